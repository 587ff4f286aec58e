// A triangle over the whole target, at the depth that stands for a chunk's number (chunk_numbers.frag).
VERTEX_IN vec2 position;

uniform float chunk_number;    // of one that is drawn, from 1

void main() { gl_Position = vec4(position, 2.0 * (chunk_number / 1024.0) - 1.0, 1.0); }
