#include "render_core/gl/shader_prefix.hpp"

namespace tedavis::gl {
namespace {

constexpr std::string_view kEs2Vertex =
    "#version 100\n"
    "precision highp float;\n"
    "#define LANE_ES2 1\n"
    "#define VERTEX_IN attribute\n"
    "#define VARYING varying\n"
    "#line 1\n";

constexpr std::string_view kEs2Fragment =
    "#version 100\n"
    "#ifdef GL_FRAGMENT_PRECISION_HIGH\n"
    "precision highp float;\n"
    "#else\n"
    "precision mediump float;\n"
    "#endif\n"
    "#define LANE_ES2 1\n"
    "#define VARYING varying\n"
    "#define FRAGMENT_COLOR gl_FragColor\n"
    "#define TEXTURE2D texture2D\n"
    "#line 1\n";

constexpr std::string_view kEs3Vertex =
    "#version 300 es\n"
    "precision highp float;\n"
    "#define LANE_ES3 1\n"
    "#define VERTEX_IN in\n"
    "#define VARYING out\n"
    "#line 1\n";

constexpr std::string_view kEs3Fragment =
    "#version 300 es\n"
    "precision highp float;\n"
    "#define LANE_ES3 1\n"
    "#define VARYING in\n"
    "layout(location = 0) out vec4 fragment_color;\n"
    "#define FRAGMENT_COLOR fragment_color\n"
    "#define TEXTURE2D texture\n"
    "#line 1\n";

}  // namespace

std::string_view shader_prefix(effects::Lane lane, ShaderStage stage) {
    if (lane == effects::Lane::es2) return stage == ShaderStage::vertex ? kEs2Vertex : kEs2Fragment;
    return stage == ShaderStage::vertex ? kEs3Vertex : kEs3Fragment;
}

}  // namespace tedavis::gl
