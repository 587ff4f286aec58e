/// A small glTF 2.0 file, made here.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace tedavis::test_support {

[[nodiscard]] inline std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        const std::size_t left = bytes.size() - n;
        const unsigned three = (bytes[n] << 16) | (left > 1 ? bytes[n + 1] << 8 : 0) | (left > 2 ? bytes[n + 2] : 0);
        for (unsigned k = 0; k < 4; ++k) text += k <= left ? kLetters[(three >> (18 - 6 * k)) & 63] : '=';
    }
    return text;
}

/// A tetrahedron with its corners at the origin and on the axes, moved up by 10 m, of half red linear light.
[[nodiscard]] inline std::string tetrahedron(std::size_t repeated = 1) {
    const float corners[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
    const unsigned short triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    std::vector<unsigned char> bytes(sizeof corners);
    std::memcpy(bytes.data(), corners, sizeof corners);
    for (std::size_t n = 0; n < repeated; ++n) {
        bytes.resize(bytes.size() + sizeof triangles);
        std::memcpy(bytes.data() + bytes.size() - sizeof triangles, triangles, sizeof triangles);
    }
    const std::string indices = std::to_string(12 * repeated), all = std::to_string(bytes.size());
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0, "translation": [0, 10, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0, 1]}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [2, 3, 4]},
{"bufferView": 1, "componentType": 5123, "count": )" +
           indices + R"(, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": )" +
           std::to_string(24 * repeated) + R"(}],
"buffers": [{"byteLength": )" +
           all + R"(, "uri": "data:application/octet-stream;base64,)" + base64(bytes) + "\"}]}";
}

}  // namespace tedavis::test_support
