#include "host_sim/replay/video_file.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kWriteBuffer_bytes = 1 << 16;
constexpr int kMaxRatePart = 30'000;  ///< of the rate's numerator and denominator: MPEG-4 takes 16 bits
constexpr double kSeekableEvery_s = 2;
constexpr const char* kQualityOfX264 = "18";  ///< of 51, the less the better
constexpr int kQualityOfMpeg4 = 2;            ///< of 31, the less the better

int write_bytes(void* opaque, std::uint8_t* bytes, int count) {
    auto& file = *static_cast<std::ostream*>(opaque);
    file.write(reinterpret_cast<const char*>(bytes), count);
    return file ? count : AVERROR(EIO);
}

std::int64_t seek_bytes(void* opaque, std::int64_t offset, int whence) {
    auto& file = *static_cast<std::ostream*>(opaque);
    if ((whence & AVSEEK_SIZE) != 0) return -1;
    const int from = whence & ~AVSEEK_FORCE;
    file.seekp(offset, from == SEEK_SET ? std::ios::beg : (from == SEEK_CUR ? std::ios::cur : std::ios::end));
    return file ? static_cast<std::int64_t>(file.tellp()) : -1;
}

const AVCodec& encoder_of(const VideoSettings& settings) {
    std::string names;
    for (const std::string& name : settings.encoders) {
        if (const AVCodec* found = avcodec_find_encoder_by_name(name.c_str())) return *found;
        names += (names.empty() ? "" : ", ") + name;
    }
    throw UserError(settings.path + ": the installed libavcodec has no encoder for it (" + names +
                    "); install a libavcodec that has one, or leave --video out");
}

void require_video_settings(const VideoSettings& s) {
    if (std::filesystem::path(s.path).extension() != ".mp4")
        throw UserError(s.path + ": a film is written as MP4; give --video a name that ends in .mp4");
    if (s.width % 2 == 0 && s.height % 2 == 0) return;
    const auto size = [](std::uint32_t width, std::uint32_t height) {
        return std::to_string(width) + "x" + std::to_string(height);
    };
    throw UserError(s.path + ": a film has colors for 2 x 2 pixels, and pictures of " + size(s.width, s.height) +
                    " have an odd side; say --size " + size(s.width + s.width % 2, s.height + s.height % 2));
}

AVRational rate_of(const VideoSettings& settings) {
    const AVRational rate = av_d2q(1 / settings.step_s, kMaxRatePart);
    if (settings.step_s > 0 && rate.num > 0 && rate.den > 0) return rate;
    throw UserError(settings.path + ": no film has a picture each " + std::to_string(settings.step_s) +
                    " s; choose another --step, or leave --video out");
}

}  // namespace

class VideoFile::Film {
public:
    explicit Film(const VideoSettings& settings) : path_(settings.path), file_(settings.path) {
        av_log_set_level(AV_LOG_QUIET);  // what goes wrong is said once, by us
        open_encoder(settings);
        open_container(settings);
        scaler_ = made(sws_getContext(encoder_->width, encoder_->height, AV_PIX_FMT_RGB0, encoder_->width, encoder_->height,
                                      AV_PIX_FMT_YUV420P, SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP,
                                      nullptr, nullptr, nullptr));
        const int* const bt709 = sws_getCoefficients(SWS_CS_ITU709);
        sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
        frame_->format = encoder_->pix_fmt;
        frame_->width = encoder_->width;
        frame_->height = encoder_->height;
        require(av_frame_get_buffer(frame_.get(), 0), "has no memory for a picture");
    }

    void add(const RgbaView& picture) {
        require(av_frame_make_writable(frame_.get()), "has no memory for a picture");
        const std::uint8_t* const rows[] = {picture.row(0)};
        const int row_bytes = static_cast<int>(picture.width) * 4;
        const int strides[] = {picture.bottom_up ? -row_bytes : row_bytes};
        sws_scale(scaler_.get(), rows, strides, 0, static_cast<int>(picture.height), frame_->data, frame_->linesize);
        frame_->pts = static_cast<std::int64_t>(pictures_++);
        encode(frame_.get());
    }

    void commit() {
        encode(nullptr);
        require(av_write_trailer(container_.get()), "cannot end it");
        avio_flush(io_.get());
        file_.commit();
    }

    [[nodiscard]] std::uint64_t pictures() const { return pictures_; }

private:
    struct LibavDeleter {
        void operator()(AVFormatContext* c) const { avformat_free_context(c); }
        void operator()(AVCodecContext* c) const { avcodec_free_context(&c); }
        void operator()(AVFrame* f) const { av_frame_free(&f); }
        void operator()(AVPacket* p) const { av_packet_free(&p); }
        void operator()(SwsContext* s) const { sws_freeContext(s); }
        void operator()(AVIOContext* io) const {
            av_freep(&io->buffer);
            avio_context_free(&io);
        }
    };
    template <class T>
    using Libav = std::unique_ptr<T, LibavDeleter>;

    template <class T>
    static Libav<T> made(T* thing) {
        if (thing == nullptr) throw UserError("--video: no memory is left for the film; ask for smaller pictures with --size");
        return Libav<T>(thing);
    }

    /// The disk is what fails most.
    void require(int result, const std::string& what) {
        if (result >= 0) return;
        if (!file_.stream()) throw UserError(path_ + ": could not be written to its end; check the free space");
        char reason[AV_ERROR_MAX_STRING_SIZE] = {};
        av_strerror(result, reason, sizeof reason);
        throw UserError(path_ + ": libav " + what + " (" + reason + "); choose another --size or --step, or leave --video out");
    }

    void open_encoder(const VideoSettings& settings) {
        const AVCodec& codec = encoder_of(settings);
        const AVRational rate = rate_of(settings);
        encoder_ = made(avcodec_alloc_context3(&codec));
        encoder_->width = static_cast<int>(settings.width);
        encoder_->height = static_cast<int>(settings.height);
        encoder_->pix_fmt = AV_PIX_FMT_YUV420P;
        encoder_->framerate = rate;
        encoder_->time_base = av_inv_q(rate);
        encoder_->gop_size = std::max(1, static_cast<int>(std::lround(kSeekableEvery_s * av_q2d(rate))));
        encoder_->thread_count = 1;
        encoder_->color_range = AVCOL_RANGE_MPEG;
        encoder_->colorspace = AVCOL_SPC_BT709;
        encoder_->color_primaries = AVCOL_PRI_BT709;
        encoder_->color_trc = AVCOL_TRC_BT709;
        encoder_->flags |= AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_GLOBAL_HEADER;
        if (codec.id == AV_CODEC_ID_H264) {
            av_opt_set(encoder_->priv_data, "crf", kQualityOfX264, 0);
        } else {
            encoder_->flags |= AV_CODEC_FLAG_QSCALE;
            encoder_->global_quality = kQualityOfMpeg4 * FF_QP2LAMBDA;
        }
        require(avcodec_open2(encoder_.get(), &codec, nullptr), std::string("cannot encode such pictures by ") + codec.name);
    }

    void open_container(const VideoSettings& settings) {
        AVFormatContext* container = nullptr;
        require(avformat_alloc_output_context2(&container, nullptr, "mp4", nullptr), "has no MP4 container");
        container_.reset(container);
        auto* const buffer = static_cast<unsigned char*>(av_malloc(kWriteBuffer_bytes));
        io_ = made(avio_alloc_context(buffer, kWriteBuffer_bytes, 1, &file_.stream(), nullptr, write_bytes, seek_bytes));
        container->pb = io_.get();
        container->flags |= AVFMT_FLAG_CUSTOM_IO | AVFMT_FLAG_BITEXACT;
        AVStream* const stream = avformat_new_stream(container, nullptr);
        if (stream == nullptr) require(AVERROR(ENOMEM), "has no memory for the film");
        stream->time_base = encoder_->time_base;
        stream->avg_frame_rate = encoder_->framerate;
        require(avcodec_parameters_from_context(stream->codecpar, encoder_.get()), "has no memory for the film");
        const std::string begin = utc_text(settings.begin);
        for (const auto& [key, text] : {std::pair<const char*, std::string>{"title", settings.title},
                                        {"creation_time", begin},
                                        {"date", begin},
                                        {"comment", "Flight time of the first picture: " + begin + ". Not for navigation."}})
            av_dict_set(&container->metadata, key, text.c_str(), 0);
        require(avformat_write_header(container, nullptr), "cannot begin it");
    }

    /// Null: no more pictures follow.
    void encode(const AVFrame* frame) {
        require(avcodec_send_frame(encoder_.get(), frame), "cannot encode picture " + std::to_string(pictures_));
        for (;;) {
            const int received = avcodec_receive_packet(encoder_.get(), packet_.get());
            if (received == AVERROR(EAGAIN) || received == AVERROR_EOF) break;
            require(received, "cannot encode picture " + std::to_string(pictures_));
            packet_->duration = 1;
            av_packet_rescale_ts(packet_.get(), encoder_->time_base, container_->streams[0]->time_base);
            require(av_interleaved_write_frame(container_.get(), packet_.get()), "cannot write it");
        }
        require(io_->error, "cannot write it");
    }

    std::string path_;
    AtomicFile file_;
    std::uint64_t pictures_ = 0;
    Libav<AVCodecContext> encoder_;
    Libav<AVIOContext> io_;
    Libav<AVFormatContext> container_;
    Libav<SwsContext> scaler_;
    Libav<AVFrame> frame_ = made(av_frame_alloc());
    Libav<AVPacket> packet_ = made(av_packet_alloc());
};

VideoFile::VideoFile(const VideoSettings& settings) {
    require_video_settings(settings);
    film_ = std::make_unique<Film>(settings);
}

VideoFile::~VideoFile() = default;

void VideoFile::add(const RgbaView& picture) { film_->add(picture); }

std::uint64_t VideoFile::pictures() const { return film_->pictures(); }

void VideoFile::commit() { film_->commit(); }

}  // namespace tedavis::host_sim
