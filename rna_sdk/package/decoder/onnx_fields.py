"""Numbers of the fields of ONNX messages that this project reads or writes.

From onnx.proto of ONNX 1.16 (IR version 10); the names are those of that file.
"""


class ModelProto:
    IR_VERSION, PRODUCER_NAME, GRAPH, OPSET_IMPORT = 1, 2, 7, 8
    TRAINING_INFO, FUNCTIONS = 20, 25


class OperatorSetIdProto:
    DOMAIN, VERSION = 1, 2


class GraphProto:
    NODE, NAME, INITIALIZER, INPUT, OUTPUT, SPARSE_INITIALIZER = 1, 2, 5, 11, 12, 15


class NodeProto:
    INPUT, OUTPUT, OP_TYPE, ATTRIBUTE, DOMAIN = 1, 2, 4, 5, 7


class AttributeProto:
    NAME, I, INTS, TYPE = 1, 3, 8, 20  # noqa: E741


class TensorProto:
    DIMS, DATA_TYPE, NAME, RAW_DATA, EXTERNAL_DATA, DATA_LOCATION = 1, 2, 8, 9, 13, 14
    OTHER_DATA = 3, 4, 5, 6, 7, 10, 11
    """Values elsewhere than in RAW_DATA."""


class ValueInfoProto:
    NAME, TYPE = 1, 2


class TypeProto:
    TENSOR_TYPE = 1


class TensorTypeProto:
    ELEM_TYPE, SHAPE = 1, 2


class TensorShapeProto:
    DIM = 1


class DimensionProto:
    DIM_VALUE, DIM_PARAM = 1, 2


class DataType:
    """Element type of a tensor."""

    FLOAT, UINT8, INT8, INT32, INT64 = 1, 2, 3, 6, 7


class AttributeType:
    """Type of an attribute's value."""

    INT, INTS = 2, 7
