/// A surface that counts the triangles handed to GL, of whatever pass. One at a time.
#pragma once

#include <GLES3/gl3.h>

#include <cstring>
#include <memory>
#include <string_view>

#include "render_core/base/ports/surface.hpp"

namespace tedavis::test_support {

class CountedTriangles final : public base::Surface {
public:
    explicit CountedTriangles(std::unique_ptr<base::Surface> surface) : surface_(std::move(surface)) { count() = 0; }
    [[nodiscard]] static std::unique_ptr<base::Surface> wrap(std::unique_ptr<base::Surface> surface) {
        return std::make_unique<CountedTriangles>(std::move(surface));
    }
    /// Since it was set last.
    [[nodiscard]] static std::uint64_t& count() {
        static std::uint64_t triangles = 0;
        return triangles;
    }

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
        if (called == "glDrawArrays") return instead(found, original<PFNGLDRAWARRAYSPROC>(), &draw_arrays);
        if (called == "glDrawElements") return instead(found, original<PFNGLDRAWELEMENTSPROC>(), &draw_elements);
        if (called == "glDrawRangeElements") return instead(found, original<PFNGLDRAWRANGEELEMENTSPROC>(), &draw_range);
        if (called == "glDrawElementsInstanced")
            return instead(found, original<PFNGLDRAWELEMENTSINSTANCEDPROC>(), &draw_instances);
        return found;
    }

private:
    // GL's entry points have no object.
    template <class Call>
    static Call& original() {
        static Call call = nullptr;
        return call;
    }
    template <class Call>
    static void* instead(void* found, Call& kept, Call counting) {
        std::memcpy(&kept, &found, sizeof kept);
        void* address = nullptr;
        std::memcpy(&address, &counting, sizeof address);
        return address;
    }
    static void add(GLenum mode, GLsizei corners, GLsizei times) {
        if (mode == GL_TRIANGLES) count() += static_cast<std::uint64_t>(corners) / 3 * static_cast<std::uint64_t>(times);
        if (mode == GL_TRIANGLE_STRIP && corners > 2) count() += static_cast<std::uint64_t>(corners - 2);
    }

    static void draw_arrays(GLenum mode, GLint first, GLsizei corners) {
        add(mode, corners, 1);
        original<PFNGLDRAWARRAYSPROC>()(mode, first, corners);
    }
    static void draw_elements(GLenum mode, GLsizei corners, GLenum type, const void* indices) {
        add(mode, corners, 1);
        original<PFNGLDRAWELEMENTSPROC>()(mode, corners, type, indices);
    }
    static void draw_range(GLenum mode, GLuint start, GLuint end, GLsizei corners, GLenum type, const void* indices) {
        add(mode, corners, 1);
        original<PFNGLDRAWRANGEELEMENTSPROC>()(mode, start, end, corners, type, indices);
    }
    static void draw_instances(GLenum mode, GLsizei corners, GLenum type, const void* indices, GLsizei times) {
        add(mode, corners, times);
        original<PFNGLDRAWELEMENTSINSTANCEDPROC>()(mode, corners, type, indices, times);
    }

    std::unique_ptr<base::Surface> surface_;
};

}  // namespace tedavis::test_support
