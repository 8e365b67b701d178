"""Rays against geometry: Embree, and points on surfaces and strands."""
