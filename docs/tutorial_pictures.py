"""Takes the pictures of the newcomer's ways in the window over into docs/images.

python docs/tutorial_pictures.py FOLDER
"""

import sys
from pathlib import Path

from PIL import Image

IMAGES = Path(__file__).parent / "images"

for way, prefix in (("path", "path"), ("walk", "tutorial")):
    for picture in sorted(Path(sys.argv[1], way).glob("[0-9]_*.png")):
        file = IMAGES / f"{prefix}_{picture.stem}.jpg"
        Image.open(picture).convert("RGB").save(file, quality=85, optimize=True)
