#include "host_sim/png_file.hpp"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kCompression = 1;  // frames are written by the hundred: a larger file for a fraction of the time
constexpr std::uint32_t kMostPixelsASide = 32768;

void append_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void nothing_to_flush(png_structp) {}

void ignore_warning(png_structp, png_const_charp) {}

[[noreturn]] void stop_encoding(png_structp, png_const_charp message) {
    throw std::runtime_error(std::string("PNG encoder: ") + message);
}

struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, stop_encoding, ignore_warning);
    png_infop info = png_create_info_struct(png);
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

/// Frees what the simplified reader holds, on every way out.
struct Reader {
    png_image image{};
    Reader() { image.version = PNG_IMAGE_VERSION; }
    ~Reader() { png_image_free(&image); }
};

template <class View>
std::string encoded(const View& view, int color_type) {
    std::string bytes;
    Writer writer;
    png_set_write_fn(writer.png, &bytes, append_bytes, nothing_to_flush);
    png_set_compression_level(writer.png, kCompression);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(writer.png, writer.info, view.width, view.height, 8, color_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(writer.png, writer.info);
    for (std::uint32_t y = 0; y < view.height; ++y) png_write_row(writer.png, view.row(y));
    png_write_end(writer.png, writer.info);
    return bytes;
}

}  // namespace

std::string encode_png(const RgbaView& view) { return encoded(view, PNG_COLOR_TYPE_RGBA); }

std::string encode_grey_png(const GreyView& view) { return encoded(view, PNG_COLOR_TYPE_GRAY); }

void write_png(const std::string& path, const RgbaView& view) { write_file_atomically(path, encode_png(view)); }

RgbaPicture read_png(const std::string& path) {
    const std::string bytes = read_file(path);
    Reader reader;
    const auto refuse = [&]() -> UserError {
        return UserError(path + ": not a sound PNG picture (" + reader.image.message + "); write it again");
    };
    if (png_image_begin_read_from_memory(&reader.image, bytes.data(), bytes.size()) == 0) throw refuse();
    if (reader.image.width > kMostPixelsASide || reader.image.height > kMostPixelsASide)
        throw UserError(path + ": larger than 32768 pixels a side; scale it down");
    reader.image.format = PNG_FORMAT_RGBA;
    RgbaPicture picture{reader.image.width, reader.image.height, {}};
    picture.pixels.resize(PNG_IMAGE_SIZE(reader.image));
    if (png_image_finish_read(&reader.image, nullptr, picture.pixels.data(), 0, nullptr) == 0) throw refuse();
    if (PNG_IMAGE_FAILED(reader.image)) throw refuse();
    return picture;
}

RgbaPicture upright(const RgbaView& view) {
    RgbaPicture picture{view.width, view.height, {}};
    picture.pixels.reserve(std::size_t{view.width} * view.height * 4);
    for (std::uint32_t y = 0; y < view.height; ++y)
        picture.pixels.insert(picture.pixels.end(), view.row(y), view.row(y) + std::size_t{view.width} * 4);
    return picture;
}

RgbaPicture shrunk(const RgbaView& view, std::uint32_t max_width) {
    const std::uint32_t factor = std::max<std::uint32_t>(1, (view.width + max_width - 1) / max_width);
    RgbaPicture small{(view.width + factor - 1) / factor, (view.height + factor - 1) / factor, {}};
    small.pixels.resize(static_cast<std::size_t>(small.width) * small.height * 4);
    for (std::uint32_t y = 0; y < small.height; ++y) {
        for (std::uint32_t x = 0; x < small.width; ++x) {
            std::array<std::uint32_t, 4> sums{};
            std::uint32_t count = 0;
            for (std::uint32_t v = y * factor; v < std::min(view.height, (y + 1) * factor); ++v) {
                for (std::uint32_t u = x * factor; u < std::min(view.width, (x + 1) * factor); ++u, ++count) {
                    for (std::size_t c = 0; c < 4; ++c) sums[c] += view.row(v)[std::size_t{u} * 4 + c];
                }
            }
            std::uint8_t* out = &small.pixels[(std::size_t{y} * small.width + x) * 4];
            for (std::size_t c = 0; c < 4; ++c) out[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
        }
    }
    return small;
}

}  // namespace tedavis::host_sim
