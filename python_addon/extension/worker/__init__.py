"""The host's side of the worker process: starting it, talking to it, reading its arrays.

Nothing here touches bpy, and nothing here imports the core.
"""
