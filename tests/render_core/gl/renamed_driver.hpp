/// A surface whose driver says that it is another one: what is decided by a driver's name can be tried on any machine.
#pragma once

#include <GLES2/gl2.h>

#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "render_core/base/ports/surface.hpp"

namespace tedavis::test_support {

class RenamedDriver final : public base::Surface {
public:
    RenamedDriver(std::unique_ptr<base::Surface> real, std::string renderer) : real_(std::move(real)) {
        renderer_name() = std::move(renderer);
    }
    [[nodiscard]] std::uint32_t width() const override { return real_->width(); }
    [[nodiscard]] std::uint32_t height() const override { return real_->height(); }
    [[nodiscard]] bool make_current() override { return real_->make_current(); }
    void release_current() override { real_->release_current(); }
    [[nodiscard]] void* proc_address(const char* name) override {
        void* const found = real_->proc_address(name);
        if (std::strcmp(name, "glGetString") != 0) return found;
        real_get_string() = reinterpret_cast<GetString>(found);
        return reinterpret_cast<void*>(&get_string);
    }
    [[nodiscard]] base::SurfaceState present() override { return real_->present(); }
    [[nodiscard]] std::uint32_t framebuffer() const override { return real_->framebuffer(); }
    [[nodiscard]] const char* backend_name() const override { return real_->backend_name(); }

private:
    using GetString = const GLubyte* (*)(GLenum);

    static const GLubyte* get_string(GLenum name) {
        if (name == GL_RENDERER) return reinterpret_cast<const GLubyte*>(renderer_name().c_str());
        return real_get_string()(name);
    }
    // GL's entry points have no object: one such surface at a time.
    static std::string& renderer_name() {
        static std::string name;
        return name;
    }
    static GetString& real_get_string() {
        static GetString real = nullptr;
        return real;
    }

    std::unique_ptr<base::Surface> real_;
};

}  // namespace tedavis::test_support
