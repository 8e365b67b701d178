"""Bakes objects of Blender into packages."""
