"""Datasets: folders of captured rays and images."""
