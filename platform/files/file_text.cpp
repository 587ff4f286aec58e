#include "platform/files/file_text.hpp"

#include <utility>

#include "platform/files/file_byte_source.hpp"

namespace tedavis::platform {

base::Result<FileText, base::Error> read_file_text(const char* path) {
    auto file = open_file(path);
    if (!file.ok()) return base::fail(base::make_error(file.error().message.view()));
    const std::uint64_t size = file.value().size();
    if (size > kMaxFileTextBytes)
        return base::fail(base::make_error(path, ": is larger than 1 MiB and no configuration file; name another"));
    FileText result;
    if (size == 0) return result;
    auto block = reserve_memory(size, Residency::lazy);
    if (!block.ok()) return base::fail(base::make_error(path, ": ", block.error().message.view()));
    result.block_ = std::move(block.value());
    base::Arena arena = result.block_.arena();
    void* bytes = arena.allocate(static_cast<std::size_t>(size), 1);
    if (!file.value().read(0, bytes, static_cast<std::size_t>(size)))
        return base::fail(base::make_error(path, ": cannot be read to its end; check the medium"));
    result.text_ = {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
    return result;
}

}  // namespace tedavis::platform
