#include "render_core/gl/capability_probe.hpp"

#include <cstring>

#include "render_core/base/driver_scope.hpp"

namespace tedavis::gl {
namespace {

using GetStringFn = const GLubyte*(GL_APIENTRY*)(GLenum);
using GetIntegervFn = void(GL_APIENTRY*)(GLenum, GLint*);
using GetErrorFn = GLenum(GL_APIENTRY*)();

struct Queries {
    GetStringFn get_string;
    GetIntegervFn get_integer;
    GetErrorFn get_error;

    const char* text(GLenum name) const {
        const GLubyte* answer = get_string(name);
        return answer == nullptr ? "" : reinterpret_cast<const char*>(answer);
    }
    GLint integer(GLenum name) const {
        GLint value = 0;
        get_integer(name, &value);
        return value;
    }
};

bool at_least(const DriverFacts& facts, int es_major, int es_minor, int gl_major, int gl_minor) {
    const int major = facts.embedded ? es_major : gl_major;
    const int minor = facts.embedded ? es_minor : gl_minor;
    return facts.major > major || (facts.major == major && facts.minor >= minor);
}

void read_extensions(const char* extensions, DriverFacts& facts) {
    facts.depth24_targets = at_least(facts, 3, 0, 3, 0) || has_extension(extensions, "GL_OES_depth24");
    facts.texture_storage = at_least(facts, 3, 0, 4, 2) || has_extension(extensions, "GL_EXT_texture_storage");
    facts.program_binary = at_least(facts, 3, 0, 4, 1) || has_extension(extensions, "GL_OES_get_program_binary");
    facts.robustness = at_least(facts, 3, 2, 4, 5) || has_extension(extensions, "GL_KHR_robustness") ||
                       has_extension(extensions, "GL_EXT_robustness");
}

void read_limits(const Queries& gl, DriverFacts& facts) {
    facts.depth_bits = gl.integer(GL_DEPTH_BITS);
    facts.max_texture_px = gl.integer(GL_MAX_TEXTURE_SIZE);
    facts.max_attributes = gl.integer(GL_MAX_VERTEX_ATTRIBS);
    facts.max_texture_units = gl.integer(GL_MAX_TEXTURE_IMAGE_UNITS);
    facts.max_vertex_texture_units = gl.integer(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS);
    if (facts.program_binary) facts.program_binary_formats = gl.integer(GL_NUM_PROGRAM_BINARY_FORMATS);
    constexpr int kMaxPendingErrors = 16;  // a lost context may report for ever
    for (int i = 0; i < kMaxPendingErrors && gl.get_error() != GL_NO_ERROR; ++i) {
    }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

const char* read_number(const char* p, std::int32_t& value) {
    constexpr std::int32_t kMaxVersion = 1000;
    for (value = 0; is_digit(*p) && value < kMaxVersion; ++p) value = value * 10 + (*p - '0');
    return p;
}

}  // namespace

bool parse_version(const char* text, DriverFacts& facts) {
    constexpr const char* kEmbedded = "OpenGL ES ";
    facts.embedded = std::strncmp(text, kEmbedded, std::strlen(kEmbedded)) == 0;
    const char* p = facts.embedded ? text + std::strlen(kEmbedded) : text;
    if (!is_digit(*p)) return false;
    p = read_number(p, facts.major);
    if (*p != '.' || !is_digit(p[1])) return false;
    read_number(p + 1, facts.minor);
    return true;
}

bool has_extension(const char* list, const char* name) {
    const std::size_t length = std::strlen(name);
    if (length == 0) return false;
    for (const char* p = std::strstr(list, name); p != nullptr; p = std::strstr(p + length, name)) {
        const bool starts = p == list || p[-1] == ' ';
        const bool ends = p[length] == ' ' || p[length] == '\0';
        if (starts && ends) return true;
    }
    return false;
}

bool provides(const DriverFacts& facts, CallOrigin origin) {
    switch (origin) {
        case CallOrigin::es20: return at_least(facts, 2, 0, 4, 1);
        case CallOrigin::es30: return at_least(facts, 3, 0, 4, 3);
        case CallOrigin::storage: return facts.texture_storage;
        case CallOrigin::binary: return facts.program_binary;
        case CallOrigin::robust: return facts.robustness;
    }
    return false;
}

base::Result<DriverFacts, base::Error> probe_driver(base::Surface& surface) {
    const Queries gl{reinterpret_cast<GetStringFn>(surface.proc_address("glGetString")),
                     reinterpret_cast<GetIntegervFn>(surface.proc_address("glGetIntegerv")),
                     reinterpret_cast<GetErrorFn>(surface.proc_address("glGetError"))};
    if (gl.get_string == nullptr || gl.get_integer == nullptr || gl.get_error == nullptr)
        return base::fail(base::make_error("the ", surface.backend_name(), " surface has no GL; install a GL ES driver"));
    const base::DriverScope driver;
    DriverFacts facts;
    facts.version = gl.text(GL_VERSION);
    facts.renderer = gl.text(GL_RENDERER);
    facts.vendor = gl.text(GL_VENDOR);
    if (!parse_version(facts.version.c_str(), facts))
        return base::fail(base::make_error("the driver's version '", facts.version.view(),
                                           "' is not readable; make the surface current before opening GL on it"));
    read_extensions(gl.text(GL_EXTENSIONS), facts);
    read_limits(gl, facts);
    return facts;
}

}  // namespace tedavis::gl
