"""What a terrain's children are there for: a custom property of theirs."""

ROLE = "orogen_role"


def with_role(terrain, role):
    return [child for child in terrain.children if child.get(ROLE) == role]
