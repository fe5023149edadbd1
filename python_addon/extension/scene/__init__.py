"""Reading what is drawn in the scene. Only this folder knows grease pencil's generations."""
