/// A surface whose numbers are watched on their way to GL: uniforms, and vertices of terrain chunks. One at a time.
#pragma once

#include <GLES2/gl2.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

#include "render_core/base/ports/surface.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::test_support {

class WatchedSurface final : public base::Surface {
public:
    struct Counts {
        std::uint64_t numbers = 0, not_finite = 0;
    };

    explicit WatchedSurface(std::unique_ptr<base::Surface> surface) : surface_(std::move(surface)) { counts() = {}; }

    [[nodiscard]] std::uint32_t width() const override { return surface_->width(); }
    [[nodiscard]] std::uint32_t height() const override { return surface_->height(); }
    [[nodiscard]] bool make_current() override { return surface_->make_current(); }
    void release_current() override { surface_->release_current(); }
    [[nodiscard]] base::SurfaceState present() override { return surface_->present(); }
    [[nodiscard]] std::uint32_t framebuffer() const override { return surface_->framebuffer(); }
    [[nodiscard]] const char* backend_name() const override { return surface_->backend_name(); }
    [[nodiscard]] void* proc_address(const char* name) override {
        void* const found = surface_->proc_address(name);
        const std::string_view called(name);
        if (called == "glUniform1f") return instead(found, original<PFNGLUNIFORM1FPROC>(), &uniform1f);
        if (called == "glUniform2f") return instead(found, original<PFNGLUNIFORM2FPROC>(), &uniform2f);
        if (called == "glUniform3f") return instead(found, original<PFNGLUNIFORM3FPROC>(), &uniform3f);
        if (called == "glUniform4f") return instead(found, original<PFNGLUNIFORM4FPROC>(), &uniform4f);
        if (called == "glUniform1fv") return instead(found, vector<1>(), &uniform_vector<1>);
        if (called == "glUniform2fv") return instead(found, vector<2>(), &uniform_vector<2>);
        if (called == "glUniform3fv") return instead(found, vector<3>(), &uniform_vector<3>);
        if (called == "glUniform4fv") return instead(found, vector<4>(), &uniform_vector<4>);
        if (called == "glUniformMatrix3fv") return instead(found, matrix<9>(), &uniform_matrix<9>);
        if (called == "glUniformMatrix4fv") return instead(found, matrix<16>(), &uniform_matrix<16>);
        if (called == "glBufferSubData") return instead(found, original<PFNGLBUFFERSUBDATAPROC>(), &buffer_sub_data);
        return found;
    }

    [[nodiscard]] static Counts& counts() {
        static Counts all;
        return all;
    }

private:
    template <class Call>
    static Call& original() {
        static Call call = nullptr;
        return call;
    }
    template <int N>
    static PFNGLUNIFORM1FVPROC& vector() {
        static PFNGLUNIFORM1FVPROC call = nullptr;
        return call;
    }
    template <int N>
    static PFNGLUNIFORMMATRIX4FVPROC& matrix() {
        static PFNGLUNIFORMMATRIX4FVPROC call = nullptr;
        return call;
    }
    template <class Call>
    static void* instead(void* found, Call& kept, Call watching) {
        std::memcpy(&kept, &found, sizeof kept);
        void* address = nullptr;
        std::memcpy(&address, &watching, sizeof address);
        return address;
    }
    static void watch(float number) {
        ++counts().numbers;
        counts().not_finite += std::isfinite(number) ? 0 : 1;
    }
    static void watch(const float* numbers, GLsizei count) {
        for (GLsizei n = 0; n < count; ++n) watch(numbers[n]);
    }

    static void uniform1f(GLint at, GLfloat x) { watch(x), original<PFNGLUNIFORM1FPROC>()(at, x); }
    static void uniform2f(GLint at, GLfloat x, GLfloat y) { watch(x), watch(y), original<PFNGLUNIFORM2FPROC>()(at, x, y); }
    static void uniform3f(GLint at, GLfloat x, GLfloat y, GLfloat z) {
        watch(x), watch(y), watch(z), original<PFNGLUNIFORM3FPROC>()(at, x, y, z);
    }
    static void uniform4f(GLint at, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
        watch(x), watch(y), watch(z), watch(w), original<PFNGLUNIFORM4FPROC>()(at, x, y, z, w);
    }
    template <int N>
    static void uniform_vector(GLint at, GLsizei count, const GLfloat* numbers) {
        watch(numbers, N * count);
        vector<N>()(at, count, numbers);
    }
    template <int N>
    static void uniform_matrix(GLint at, GLsizei count, GLboolean turned, const GLfloat* numbers) {
        watch(numbers, N * count);
        matrix<N>()(at, count, turned, numbers);
    }
    /// Without symbols, what is uploaded in whole chunk vertices are such.
    static void buffer_sub_data(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
        constexpr GLsizeiptr kVertex = sizeof(terrain::ChunkVertex);
        for (GLsizeiptr at = 0; target == GL_ARRAY_BUFFER && size % kVertex == 0 && at < size; at += kVertex) {
            float numbers[4];
            std::memcpy(numbers, static_cast<const char*>(data) + at, sizeof numbers);
            watch(numbers, 4);
        }
        original<PFNGLBUFFERSUBDATAPROC>()(target, offset, size, data);
    }

    std::unique_ptr<base::Surface> surface_;
};

}  // namespace tedavis::test_support
