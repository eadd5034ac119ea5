// Stands for a source where CMake asks for one: what is compiled here is the headers that all share.
