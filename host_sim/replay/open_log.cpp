#include "host_sim/replay/open_log.hpp"

#include <cstring>
#include <utility>

#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "platform/files/file_byte_source.hpp"

namespace tedavis::host_sim {
namespace {

class UnpackedLog final : public base::ByteSource {
public:
    explicit UnpackedLog(std::string text) : text_(std::move(text)) {}

    [[nodiscard]] std::uint64_t size() const override { return text_.size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        if (count > text_.size() || offset > text_.size() - count) return false;
        std::memcpy(destination, text_.data() + offset, count);
        return true;
    }

private:
    std::string text_;
};

bool is_gzip(base::ByteSource& file) {
    unsigned char magic[2] = {};  // RFC 1952, 2.3.1
    return file.read(0, magic, sizeof magic) && magic[0] == 0x1F && magic[1] == 0x8B;
}

}  // namespace

std::unique_ptr<base::ByteSource> open_log(const std::string& path) {
    auto opened = platform::open_file(path.c_str());
    if (!opened.ok()) throw UserError(std::string(opened.error().message.view()));
    auto file = std::make_unique<platform::FileByteSource>(std::move(opened.value()));
    if (!is_gzip(*file)) return file;
    return std::make_unique<UnpackedLog>(read_file_unpacked(path));
}

}  // namespace tedavis::host_sim
