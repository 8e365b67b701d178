"""Other methods for relightable assets, trained and rendered on our data: `rna-bench peers`.

A method (`method.py`) trains on `Views` (`views.py`: images, cameras, point lights in the unit
sphere) until it has used its `Budget`, resumes from a checkpoint, and renders radiance of a camera
and a point light. To add one:

- write a `LearnedMethod` (`learned_method.py`): a `torch.nn.Module` with `loss(batch, progress)`
  and `radiance(rays)`; training, checkpoints, records and rendering in chunks are inherited;
- give it a row in `methods.py`, with its published schedule.

`views_reader.py` reads folders in NRHints' layout, ours and those of others.
"""
