"""Colour scales that the colour-blind can read, and colours for classes. No bpy here.

viridis and cividis (van der Walt, Smith, Nuñez and others), batlow, vik and oleron (Crameri 2018)
at equal distances, sRGB; between them colours are blended. At "|", the middle, oleron breaks, as
ground does at the coast. Classes: Okabe and Ito (2008), grey for black. Water's scale is our own.
"""

import numpy as np

_STOPS = {
    "VIRIDIS": "440154 482576 414487 355f8d 2a788e 21918c 22a884 42be71 7ad151 bddf26 fde725",
    "CIVIDIS": "00224e 0c3470 35456c 4f576c 666970 7d7c78 948e77 ada272 c8b866 e5cf52 fee838",
    "BATLOW": "011959 103d5f 185562 30685c 577647 828231 b38e2f e09651 fba689 fdb9c2 faccfa",
    "VIK": "001261 023a7b 116496 5496b7 a7c9da ece5e0 e1b8a0 cd8961 b75a26 852206 590008",
    "OLERON": "1a2659 414d80 6c79ac 99a6d9 c4d1f6 e6f2ff |"
    " 1a4c00 535e02 8e7d33 c5a46c f3d4ab fdfde6",
    "WATER": "9c9484 8aa0a6 6d9fc0 3f86c2 1f63ad 0b3f86 06245c",  # from dry ground
}
_CLASSES = "999999 e69f00 56b4e9 009e73 f0e442 0072b2 d55e00 cc79a7"  # the first is for 0
STEPS = 1024


def _colours(text):
    return np.array([list(bytes.fromhex(word)) for word in text.split()], np.float64) / 255.0


def stops(scale):
    """Places (n) from 0 to 1, and their colours (n, 3)."""
    parts = [_colours(part) for part in _STOPS[scale].split("|")]
    sides = np.linspace(0.0, 1.0, len(parts) + 1)
    places = [
        np.linspace(low, high, len(part))
        for low, high, part in zip(sides[:-1], sides[1:], parts, strict=True)
    ]
    return np.concatenate(places), np.concatenate(parts)


def table(scale):
    """A scale's colours (STEPS, 3), sRGB bytes."""
    places, of_places = stops(scale)
    at = np.linspace(0.0, 1.0, STEPS)
    blended = [np.interp(at, places, channel) for channel in of_places.T]
    return np.rint(255 * np.stack(blended, axis=-1)).astype(np.uint8)


def step_of(share):
    """Which colour of the table a share has, from 0 to 1; beyond, the ends'."""
    return np.clip(np.asarray(share) * STEPS, 0, STEPS - 1).astype(np.int32)


def class_colours(values):
    """Colours (n, 3), sRGB bytes, for whole numbers. Seven take turns; those of the second turn are
    paler, those of the third darker, and so on."""
    values = np.asarray(values)
    low, high = int(values.min(initial=0)), int(values.max(initial=0))
    table = np.array([_class_colour(k) for k in range(low, high + 1)])
    return np.rint(255 * table).astype(np.uint8)[values - low]


def _class_colour(number):
    base = _colours(_CLASSES)
    if number == 0:
        return base[0]
    turn, place = divmod(number - 1, 7)
    towards = (0.0, 1.0, 0.0)[turn % 3]
    return base[1 + place] + (0.0, 0.5, 0.4)[turn % 3] * (towards - base[1 + place])
