"""At which frames objects are keyed, before and after actions got slots (Blender 4.4)."""


def key_frames(objects):
    """Sorted frames of all keys of the objects' own actions."""
    frames = set()
    for ob in objects:
        for curve in _curves(ob.animation_data):
            frames.update(key.co.x for key in curve.keyframe_points)
    return sorted(frames)


def _curves(data):
    action = data.action if data else None
    if action is None:
        return []
    if not hasattr(action, "layers"):
        return action.fcurves
    strips = [strip for layer in action.layers for strip in layer.strips]
    bags = [strip.channelbag(data.action_slot) for strip in strips if data.action_slot]
    return [curve for bag in bags if bag for curve in bag.fcurves]
