"""The script that makes `spec/conformance/`, and the float64 readings that its values come from.

    python -m tests.conformance.kit            write the kit
    python -m tests.conformance.kit --check    compare it with what is there

Nothing here evaluates an asset with the SDK: the blocks, the decoders and the visibility rays are
written once more, from the text of `spec/RNA.md`, in float64 and with no regard for speed.
"""
