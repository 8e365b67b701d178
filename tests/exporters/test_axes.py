import numpy as np

from rna_export.capture.blender_axes import from_blender, to_blender


def test_blenders_up_is_the_packages_up():
    assert np.array_equal(from_blender(np.array([0.0, 0.0, 1.0])), [0, 1, 0])


def test_blenders_front_is_the_packages_front():
    # Blender's front view looks along +Y, glTF's front faces +Z.
    assert np.array_equal(from_blender(np.array([0.0, -1.0, 0.0])), [0, 0, 1])


def test_round_trip():
    vectors = np.random.default_rng(0).normal(size=(4, 5, 3)).astype(np.float32)
    assert np.array_equal(from_blender(to_blender(vectors)), vectors)
    assert np.array_equal(to_blender(from_blender(vectors)), vectors)


def test_handedness_is_kept():
    assert np.isclose(np.linalg.det(to_blender(np.eye(3))), 1.0)
