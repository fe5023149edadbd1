"""Takes the pictures of the newcomer's way in the window over into docs/images.

python docs/tutorial_pictures.py FOLDER
"""

import sys
from pathlib import Path

from PIL import Image

IMAGES = Path(__file__).parent / "images"

for picture in sorted(Path(sys.argv[1]).glob("[0-9]_*.png")):
    file = IMAGES / f"tutorial_{picture.stem}.jpg"
    Image.open(picture).convert("RGB").save(file, quality=85, optimize=True)
