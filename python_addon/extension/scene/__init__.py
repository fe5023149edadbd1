"""Reading what is drawn in the scene, and making it. Only this folder knows grease pencil's
generations."""
