// The vertex stage of the oracle: patches are told apart by gl_PrimitiveID, so there is nothing to do.
#version 450

void main() {}
