#include "host_sim/png_file.hpp"

#include <png.h>

#include <algorithm>
#include <cstring>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kCompression = 1;  // frames are written by the hundred: a larger file for a fraction of the time
constexpr int kMaxCompression = 9;
constexpr std::uint32_t kMaxPixelsASide = 32768;

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

[[noreturn]] void stop_decoding(png_structp, png_const_charp message) { throw std::runtime_error(message); }

struct PngSource {
    const char* at;
    std::size_t left;
};

void take_bytes(png_structp png, png_bytep out, png_size_t count) {
    PngSource& source = *static_cast<PngSource*>(png_get_io_ptr(png));
    if (count > source.left) stop_decoding(png, "it ends too early");
    std::memcpy(out, source.at, count);
    source.at += count;
    source.left -= count;
}

struct Reader {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, stop_decoding, ignore_warning);
    png_infop info = png_create_info_struct(png);
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Whatever the file holds becomes eight bits of red, green, blue and alpha, as it is stored: no gamma is applied.
void ask_for_rgba(const Reader& reader) {
    png_set_expand(reader.png);
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
    (void)png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
}

RgbaPicture decoded(const std::string& bytes, const std::string& path) {
    PngSource source{bytes.data(), bytes.size()};
    const Reader reader;
    png_set_read_fn(reader.png, &source, take_bytes);
    png_set_option(reader.png, PNG_IGNORE_ADLER32, PNG_OPTION_ON);  // the chunks that it covers have checksums of their own
    png_read_info(reader.png, reader.info);
    RgbaPicture picture{png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info), {}};
    if (picture.width > kMaxPixelsASide || picture.height > kMaxPixelsASide)
        throw UserError(path + ": larger than 32768 pixels a side; scale it down");
    ask_for_rgba(reader);
    picture.pixels.resize(std::size_t{picture.width} * picture.height * 4);
    std::vector<png_bytep> rows;
    for (std::uint32_t y = 0; y < picture.height; ++y) rows.push_back(&picture.pixels[std::size_t{y} * picture.width * 4]);
    png_read_image(reader.png, rows.data());
    return picture;
}

bool is_grey(const RgbaView& view) {
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (const std::uint8_t *at = view.row(y), *end = at + std::size_t{view.width} * 4; at != end; at += 4)
            if (at[0] != at[1] || at[0] != at[2]) return false;
    return true;
}

struct PngFormat {
    int color_type, compression;
    bool is_filtered_alike;  ///< every row by the pixel before; else each as libpng finds best
    const std::vector<PaletteColor>* palette = nullptr;
};

void set_palette(const Writer& writer, const std::vector<PaletteColor>& palette) {
    std::vector<png_color> colors;
    colors.reserve(palette.size());
    for (const PaletteColor& color : palette) colors.push_back({color[0], color[1], color[2]});
    png_set_PLTE(writer.png, writer.info, colors.data(), static_cast<int>(colors.size()));
}

/// `row`: its bytes, by its number from the top.
template <class Row>
std::string encoded(std::uint32_t width, std::uint32_t height, const PngFormat& format, Row row) {
    std::string bytes;
    Writer writer;
    png_set_write_fn(writer.png, &bytes, append_bytes, nothing_to_flush);
    png_set_compression_level(writer.png, format.compression);
    if (format.is_filtered_alike) png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(writer.png, writer.info, width, height, 8, format.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (format.palette != nullptr) set_palette(writer, *format.palette);
    png_write_info(writer.png, writer.info);
    for (std::uint32_t y = 0; y < height; ++y) png_write_row(writer.png, row(y));
    png_write_end(writer.png, writer.info);
    return bytes;
}

}  // namespace

std::string encode_png(const RgbaView& view) {
    return encoded(view.width, view.height, {PNG_COLOR_TYPE_RGBA, kCompression, true},
                   [&](std::uint32_t y) { return view.row(y); });
}

std::string encode_grey_png(const GreyView& view) {
    return encoded(view.width, view.height, {PNG_COLOR_TYPE_GRAY, kCompression, true},
                   [&](std::uint32_t y) { return view.row(y); });
}

std::string encode_small_png(const RgbaView& view) {
    const std::uint32_t channels = is_grey(view) ? 1 : 3;
    std::vector<std::uint8_t> line(std::size_t{view.width} * channels);
    return encoded(view.width, view.height, {channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, kMaxCompression, false},
                   [&](std::uint32_t y) -> const std::uint8_t* {
                       for (std::uint32_t x = 0; x < view.width; ++x)
                           std::copy_n(view.row(y) + std::size_t{x} * 4, channels, &line[std::size_t{x} * channels]);
                       return line.data();
                   });
}

std::string encode_palette_png(const PalettePicture& picture) {
    return encoded(picture.width, picture.height, {PNG_COLOR_TYPE_PALETTE, kMaxCompression, false, &picture.colors},
                   [&](std::uint32_t y) { return &picture.pixels[std::size_t{y} * picture.width]; });
}

void write_png(const std::string& path, const RgbaView& view) { write_file_atomically(path, encode_png(view)); }

RgbaPicture read_png(const std::string& path) {
    const std::string bytes = read_file(path);
    try {
        return decoded(bytes, path);
    } catch (const UserError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UserError(path + ": not a sound PNG picture (" + error.what() + "); write it again");
    }
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
