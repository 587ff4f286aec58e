/// A film read back with libav, all of its pictures in memory.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"

namespace tedavis::test_support {

struct ReadFilm {
    std::string codec;
    int rate_num = 0, rate_den = 1;  ///< pictures a second
    double duration_s = 0;
    std::map<std::string, std::string> metadata;
    std::vector<double> times_s;
    std::vector<host_sim::RgbaPicture> pictures;
};

[[nodiscard]] inline host_sim::RgbaPicture rgba_of(const AVFrame& frame) {
    host_sim::RgbaPicture picture{static_cast<std::uint32_t>(frame.width), static_cast<std::uint32_t>(frame.height), {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height * 4);
    SwsContext* scaler =
        sws_getContext(frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width, frame.height,
                       AV_PIX_FMT_RGBA, SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler, bt709, 0, bt709, 1, 0, 1 << 16, 1 << 16);
    std::uint8_t* rows[] = {picture.pixels.data()};
    const int strides[] = {frame.width * 4};
    sws_scale(scaler, frame.data, frame.linesize, 0, frame.height, rows, strides);
    sws_freeContext(scaler);
    return picture;
}

/// Fails the test where the file is no film.
[[nodiscard]] inline ReadFilm read_film(const std::string& path) {
    ReadFilm film;
    AVFormatContext* file = nullptr;
    if (avformat_open_input(&file, path.c_str(), nullptr, nullptr) < 0 || avformat_find_stream_info(file, nullptr) < 0) {
        ADD_FAILURE() << path << ": is no film";
        return film;
    }
    EXPECT_EQ(file->nb_streams, 1u);
    const AVStream& stream = *file->streams[0];
    const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
    film.codec = codec->name;
    film.rate_num = stream.avg_frame_rate.num;
    film.rate_den = stream.avg_frame_rate.den;
    film.duration_s = static_cast<double>(file->duration) / AV_TIME_BASE;
    for (const AVDictionaryEntry* e = nullptr; (e = av_dict_get(file->metadata, "", e, AV_DICT_IGNORE_SUFFIX)) != nullptr;)
        film.metadata[e->key] = e->value;
    AVCodecContext* decoder = avcodec_alloc_context3(codec);
    EXPECT_GE(avcodec_parameters_to_context(decoder, stream.codecpar), 0);
    EXPECT_GE(avcodec_open2(decoder, codec, nullptr), 0);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    const auto take = [&] {
        while (avcodec_receive_frame(decoder, frame) >= 0) {
            film.times_s.push_back(static_cast<double>(frame->best_effort_timestamp) * av_q2d(stream.time_base));
            film.pictures.push_back(rgba_of(*frame));
        }
    };
    for (; av_read_frame(file, packet) >= 0; av_packet_unref(packet)) {
        EXPECT_GE(avcodec_send_packet(decoder, packet), 0);
        take();
    }
    avcodec_send_packet(decoder, nullptr);
    take();
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&decoder);
    avformat_close_input(&file);
    return film;
}

/// Peak signal-to-noise ratio of red, green and blue, dB; minus infinity for different sizes.
[[nodiscard]] inline double psnr_db(const host_sim::RgbaPicture& a, const host_sim::RgbaPicture& b) {
    if (a.width != b.width || a.height != b.height) return -std::numeric_limits<double>::infinity();
    double sum = 0;
    for (std::size_t n = 0; n < a.pixels.size(); ++n) {
        const double difference = n % 4 == 3 ? 0 : a.pixels[n] - b.pixels[n];
        sum += difference * difference;
    }
    return 10 * std::log10(255.0 * 255.0 * 0.75 * static_cast<double>(a.pixels.size()) / sum);
}

/// The same of their luma (BT.709), which a film has for each pixel.
[[nodiscard]] inline double luma_psnr_db(const host_sim::RgbaPicture& a, const host_sim::RgbaPicture& b) {
    if (a.width != b.width || a.height != b.height) return -std::numeric_limits<double>::infinity();
    constexpr double kLuma[] = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (std::size_t n = 0; n < a.pixels.size(); n += 4) {
        double difference = 0;
        for (std::size_t c = 0; c < 3; ++c) difference += kLuma[c] * (a.pixels[n + c] - b.pixels[n + c]);
        sum += difference * difference;
    }
    return 10 * std::log10(255.0 * 255.0 * 0.25 * static_cast<double>(a.pixels.size()) / sum);
}

}  // namespace tedavis::test_support
