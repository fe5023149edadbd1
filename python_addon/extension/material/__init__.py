"""Materials made of nodes. They are made once and then belong to the user."""
