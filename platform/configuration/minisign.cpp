#include "platform/configuration/minisign.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>

#include "platform/configuration/config_path.hpp"
#include "platform/files/file_text.hpp"

namespace tedavis::platform {
namespace {

constexpr std::string_view kKeyKind = "Ed", kHashedKind = "ED", kTrustedComment = "trusted comment: ";
constexpr std::size_t kKindBytes = 2, kKeyNumberBytes = 8;
constexpr std::size_t kMaxCommentBytes = 8192;

struct PublicKey {
    std::array<std::uint8_t, kKindBytes> kind{};
    std::array<std::uint8_t, kKeyNumberBytes> number{};
    std::array<std::uint8_t, crypto_sign_PUBLICKEYBYTES> key{};
};
struct FileSignature {
    std::array<std::uint8_t, kKindBytes> kind{};
    std::array<std::uint8_t, kKeyNumberBytes> number{};
    std::array<std::uint8_t, crypto_sign_BYTES> signature{};
};
using CommentSignature = std::array<std::uint8_t, crypto_sign_BYTES>;
static_assert(sizeof(PublicKey) == 42 && sizeof(FileSignature) == 74, "as minisign writes them");

/// The line of this number, from 0 on; empty where there is none.
std::string_view line_of(std::string_view text, std::size_t number) {
    for (; number > 0; --number) {
        const std::size_t end = text.find('\n');
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    return !text.empty() && text.back() == '\r' ? text.substr(0, text.size() - 1) : text;
}

template <class Plain>
bool read_base64(std::string_view line, Plain& plain) {
    std::size_t count = 0;
    return sodium_base642bin(reinterpret_cast<unsigned char*>(&plain), sizeof plain, line.data(), line.size(), nullptr, &count,
                             nullptr, sodium_base64_VARIANT_ORIGINAL) == 0 &&
           count == sizeof plain;
}

bool is_kind(const std::array<std::uint8_t, kKindBytes>& kind, std::string_view letters) {
    return std::equal(kind.begin(), kind.end(), letters.begin());
}

bool is_signed_file(const FileSignature& signature, const PublicKey& key, std::string_view content) {
    std::array<std::uint8_t, crypto_generichash_BYTES_MAX> hash{};
    crypto_generichash(hash.data(), hash.size(), reinterpret_cast<const unsigned char*>(content.data()), content.size(), nullptr,
                       0);
    return crypto_sign_verify_detached(signature.signature.data(), hash.data(), hash.size(), key.key.data()) == 0;
}

bool is_signed_comment(const CommentSignature& signature, const FileSignature& of_file, const PublicKey& key,
                       std::string_view comment) {
    std::array<std::uint8_t, crypto_sign_BYTES + kMaxCommentBytes> text{};
    if (comment.size() > kMaxCommentBytes) return false;
    std::copy(comment.begin(), comment.end(), std::copy(of_file.signature.begin(), of_file.signature.end(), text.begin()));
    return crypto_sign_verify_detached(signature.data(), text.data(), crypto_sign_BYTES + comment.size(), key.key.data()) == 0;
}

base::Error check_signature(std::string_view signature_text, std::string_view signature_file, std::string_view content,
                            std::string_view file, const PublicKey& key) {
    FileSignature signature;
    CommentSignature of_comment{};
    const std::string_view comment = line_of(signature_text, 2);
    if (!read_base64(line_of(signature_text, 1), signature) || comment.substr(0, kTrustedComment.size()) != kTrustedComment ||
        !read_base64(line_of(signature_text, 3), of_comment))
        return base::make_error(signature_file, ": is no signature of minisign; sign the pack again");
    if (!is_kind(signature.kind, kHashedKind))
        return base::make_error(signature_file, ": is a signature of the kind without a hash; sign with minisign 0.10 or newer");
    if (signature.number != key.number)
        return base::make_error(signature_file, ": is of another key than the one installed here; sign the pack with that one");
    if (!is_signed_file(signature, key, content))
        return base::make_error(file, ": is not what was signed; pack and sign again, or copy the pack again");
    if (!is_signed_comment(of_comment, signature, key, comment.substr(kTrustedComment.size())))
        return base::make_error(signature_file, ": its comment was changed after signing; copy the pack again");
    return {};
}

}  // namespace

base::Error verify_minisign(std::string_view content, std::string_view file, const char* public_key) {
    if (sodium_init() < 0) return base::make_error("signatures cannot be checked: libsodium does not start; install it again");
    const auto key_text = read_file_text(public_key);
    if (!key_text.ok()) return base::make_error("the key of packs, ", key_text.error().message.view());
    PublicKey key;
    if (!read_base64(line_of(key_text.value().view(), 1), key) || !is_kind(key.kind, kKeyKind))
        return base::make_error(public_key, ": is no public key of minisign; install the file that minisign -G wrote");
    Path signature_file(file);
    signature_file.append(".minisig");
    if (signature_file.cut()) return base::make_error(file, ": the path is too long; use a shorter one");
    const auto signature = read_file_text(signature_file.c_str());
    if (!signature.ok())
        return base::make_error(file, ": is not signed (", signature_file.view(), " cannot be read), and ", public_key,
                                " is installed here; pack with --sign");
    return check_signature(signature.value().view(), signature_file.view(), content, file, key);
}

}  // namespace tedavis::platform
