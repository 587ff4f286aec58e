/// A fragment program over the whole surface, drawn with one triangle: for looking at textures.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::test_support {

/// The texture of the sampler `image` as it is.
inline constexpr const char* kCopyFragment = "uniform sampler2D image;\nvoid main() { FRAGMENT_COLOR = TEXTURE2D(image, uv); }\n";
inline constexpr const char* kCopyUniforms[] = {"image"};

class ScreenTriangle {
public:
    /// Start stage. The text sees the varying `vec2 uv`: from 0 at the left and bottom of the surface to 1.
    explicit ScreenTriangle(gl::Gl& gl, const std::string& fragment = kCopyFragment,
                            base::Span<const char* const> uniforms = kCopyUniforms) {
        static constexpr gl::AttributeBinding kAttributes[] = {{"corner", 0}};
        const std::string text = "VARYING vec2 uv;\n" + fragment;
        gl::ProgramSource source;
        source.name = "screen triangle";
        source.vertex =
            "VERTEX_IN vec2 corner;\nVARYING vec2 uv;\n"
            "void main() {\n    uv = corner * 0.5 + 0.5;\n    gl_Position = vec4(corner, 0.0, 1.0);\n}\n";
        source.fragment = text;
        source.attributes = kAttributes;
        source.uniforms = uniforms;
        auto program = gl::build_program(gl, source);
        EXPECT_TRUE(program.ok()) << program.error().message.c_str();
        program_ = program.value();
        const float corners[] = {-1, -1, 3, -1, -1, 3};
        line_.bytes = sizeof corners;
        corners_ = std::move(gl::make_buffer(gl, line_, gl::BufferKind::vertices, gl::BufferUse::fixed, sizeof corners).value());
        EXPECT_TRUE(corners_.upload(gl, 0, corners, sizeof corners));
    }
    ScreenTriangle(const ScreenTriangle&) = delete;
    ScreenTriangle& operator=(const ScreenTriangle&) = delete;

    [[nodiscard]] const gl::Program& program() const { return program_; }
    /// On what is bound, with the program in use.
    void draw(gl::Gl& gl) const {
        corners_.bind(gl);
        gl->EnableVertexAttribArray(0);
        gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl->DrawArrays(GL_TRIANGLES, 0, 3);
        gl->DisableVertexAttribArray(0);
    }
    /// A texture of which every pixel of the surface shows its own part.
    void copy(gl::Gl& gl, const gl::Texture& texture) const {
        program_.use(gl);
        texture.bind(gl, 0);
        gl->Uniform1i(program_.uniform(0), 0);
        draw(gl);
    }
    void destroy(gl::Gl& gl) {
        corners_.destroy(gl);
        program_.destroy(gl);
    }

private:
    base::BudgetLine line_;
    gl::Program program_;
    gl::Buffer corners_;
};

}  // namespace tedavis::test_support
