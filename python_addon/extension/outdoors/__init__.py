"""What a picture of a terrain wants besides the terrain: a camera, the sun, sky and air."""
