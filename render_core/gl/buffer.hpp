/// A vertex or index buffer with fixed storage, charged to a budget line.
///
/// Memory    GPU bytes of the line. Thread  the GL thread. Lifetime  the line must outlive the buffer; destroy() releases the
/// bytes (where the device can delete); a buffer that is not destroyed lives as long as its context.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/result.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

enum class BufferKind : std::uint8_t { vertices, indices };
/// How often the content changes; a hint to the driver.
enum class BufferUse : std::uint8_t { fixed, streamed };

class Buffer {
public:
    Buffer() = default;
    Buffer(Buffer&& other) noexcept { *this = static_cast<Buffer&&>(other); }
    Buffer& operator=(Buffer&& other) noexcept;

    [[nodiscard]] bool valid() const { return id_ != 0; }
    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    void bind(Gl& gl) const;
    /// Uploads a range. Returns false, and does nothing, when the range is not inside the buffer. Leaves the buffer bound.
    [[nodiscard]] bool upload(Gl& gl, std::uint64_t offset, const void* data, std::uint64_t count) const;
    void destroy(Gl& gl);

private:
    friend base::Result<Buffer, base::Error> make_buffer(Gl&, base::BudgetLine&, BufferKind, BufferUse, std::uint64_t);
    GLuint id_ = 0;
    GLenum target_ = GL_ARRAY_BUFFER;
    std::uint64_t bytes_ = 0;
    base::BudgetLine* line_ = nullptr;
};

/// Creates a buffer; start stage only. Its content is undefined until uploaded.
[[nodiscard]] base::Result<Buffer, base::Error> make_buffer(Gl& gl, base::BudgetLine& line, BufferKind kind, BufferUse use,
                                                            std::uint64_t bytes);

}  // namespace tedavis::gl
