import bpy

settings = bpy.context.object.orogen

settings.source = "EXAMPLE"
settings.example = "corsica"
settings.resolution = 512
settings.vertical_exaggeration = 1.5
