"""Mesh files: glTF, OBJ and PLY."""
