#include "render_core/gl/buffer.hpp"

#include <utility>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/gl/gpu_memory.hpp"

namespace tedavis::gl {

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(target_, other.target_);
    std::swap(bytes_, other.bytes_);
    std::swap(line_, other.line_);
    return *this;
}

void Buffer::bind(Gl& gl) const { gl->BindBuffer(target_, id_); }

bool Buffer::upload(Gl& gl, std::uint64_t offset, const void* data, std::uint64_t count) const {
    if (!valid() || count > bytes_ || offset > bytes_ - count) return false;
    if (count == 0) return true;
    bind(gl);
    gl->BufferSubData(target_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(count), data);
    return true;
}

void Buffer::destroy(Gl& gl) {
    if (!valid()) return;
    if (gl.has(CallId::DeleteBuffers)) {
        gl->DeleteBuffers(1, &id_);
        give_back(*line_, bytes_);
    }
    id_ = 0;
    bytes_ = 0;
    line_ = nullptr;
}

base::Result<Buffer, base::Error> make_buffer(Gl& gl, base::BudgetLine& line, BufferKind kind, BufferUse use,
                                              std::uint64_t bytes) {
    if (bytes == 0)
        return base::fail(base::make_error("a buffer of the budget line '", line.name.view(), "' would be empty; ask for bytes"));
    if (!try_take(line, bytes)) return base::fail(base::shortage_error(line, bytes));
    Buffer buffer;
    buffer.target_ = kind == BufferKind::vertices ? GL_ARRAY_BUFFER : GL_ELEMENT_ARRAY_BUFFER;
    static_cast<void>(gl.take_error());
    const std::uint64_t denied = gl.denied().total;
    gl->GenBuffers(1, &buffer.id_);
    buffer.bind(gl);
    gl->BufferData(buffer.target_, static_cast<GLsizeiptr>(bytes), nullptr,
                   use == BufferUse::fixed ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW);
    if (gl.take_error() != GL_NO_ERROR || gl.denied().total != denied) {
        if (buffer.id_ != 0 && gl.stage() == Stage::start && gl.has(CallId::DeleteBuffers)) gl->DeleteBuffers(1, &buffer.id_);
        give_back(line, bytes);
        return base::fail(base::make_error("the driver refused a buffer of ", base::digits(bytes).view(),
                                           " bytes for the budget line ", line.name.view()));
    }
    buffer.bytes_ = bytes;
    buffer.line_ = &line;
    return buffer;
}

}  // namespace tedavis::gl
