"""Numbers of the fields of ONNX messages that this project reads or writes.

From onnx.proto of ONNX 1.16 (IR version 10); the names are those of that file.
"""

from __future__ import annotations


class ModelProto:
    IR_VERSION = 1
    PRODUCER_NAME = 2
    GRAPH = 7
    OPSET_IMPORT = 8
    TRAINING_INFO = 20
    FUNCTIONS = 25


class OperatorSetIdProto:
    DOMAIN = 1
    VERSION = 2


class GraphProto:
    NODE = 1
    NAME = 2
    INITIALIZER = 5
    INPUT = 11
    OUTPUT = 12
    SPARSE_INITIALIZER = 15


class NodeProto:
    INPUT = 1
    OUTPUT = 2
    OP_TYPE = 4
    ATTRIBUTE = 5
    DOMAIN = 7


class AttributeProto:
    NAME = 1
    I = 3  # noqa: E741
    INTS = 8
    TYPE = 20


class TensorProto:
    DIMS = 1
    DATA_TYPE = 2
    NAME = 8
    RAW_DATA = 9
    EXTERNAL_DATA = 13
    DATA_LOCATION = 14


class ValueInfoProto:
    NAME = 1
    TYPE = 2


class TypeProto:
    TENSOR_TYPE = 1


class TensorTypeProto:
    ELEM_TYPE = 1
    SHAPE = 2


class TensorShapeProto:
    DIM = 1


class DimensionProto:
    DIM_VALUE = 1
    DIM_PARAM = 2


class DataType:
    """Element type of a tensor."""

    FLOAT = 1
    UINT8 = 2
    INT8 = 3
    INT32 = 6
    INT64 = 7


class AttributeType:
    """Type of an attribute's value."""

    INT = 2
    INTS = 7
