"""A Lambertian sphere that every method must fit: in closed form, and as an asset."""
