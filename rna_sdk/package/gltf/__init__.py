"""Packages inside binary glTF files: the extension RNA_relightable_asset."""
