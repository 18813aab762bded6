// OpenEXR pictures to RGBA floats over the display window.
#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>

#include "io/image_codec.h"

namespace gp::io {

namespace {

using Imath::Box2i;

class MemoryStream : public Imf::IStream {
public:
    MemoryStream(std::span<const std::byte> bytes, const std::string& label)
        : Imf::IStream(label.c_str()), m_bytes(bytes) {}

    bool read(char target[], int count) override {
        if (count < 0 || uint64_t(count) > m_bytes.size() - m_position)
            throw std::runtime_error("the file ends too early");
        std::memcpy(target, m_bytes.data() + m_position, size_t(count));
        m_position += uint64_t(count);
        return m_position < m_bytes.size();
    }
    uint64_t tellg() override { return m_position; }
    void seekg(uint64_t position) override {
        if (position > m_bytes.size()) throw std::runtime_error("the file ends too early");
        m_position = position;
    }

private:
    std::span<const std::byte> m_bytes;
    uint64_t m_position = 0;
};

// Which channels of which part make the picture.
struct Choice {
    int part = 0;
    std::string channels[4];  // for R, G, B, A
    bool lumaChroma = false;  // Y, RY and BY: OpenEXR converts them itself
};

bool has(const Imf::ChannelList& list, const std::string& name) { return list.findChannel(name); }

std::optional<Choice> choose(const Imf::ChannelList& list) {
    Choice c;
    const auto layer = [&](const std::string& prefix) {
        const char* letters[4] = {"R", "G", "B", "A"};
        for (int i = 0; i < 4; ++i) c.channels[i] = prefix + letters[i];
        return has(list, c.channels[0]) && has(list, c.channels[1]) && has(list, c.channels[2]);
    };
    if (layer("")) return c;
    if (has(list, "Y")) {
        c.lumaChroma = has(list, "RY") && has(list, "BY");
        for (int i = 0; i < 3; ++i) c.channels[i].assign(1, 'Y');
        c.channels[3].assign(1, 'A');
        return c;
    }
    for (auto it = list.begin(); it != list.end(); ++it) {
        const std::string name = it.name();
        const size_t dot = name.rfind('.');
        if (dot != std::string::npos && layer(name.substr(0, dot + 1))) return c;
    }
    return std::nullopt;
}

Choice choosePart(const Imf::MultiPartInputFile& file, const ImageSource& source) {
    for (int i = 0; i < file.parts(); ++i) {
        const Imf::Header& header = file.header(i);
        if (header.hasType() && Imf::isDeepData(header.type())) continue;
        if (std::optional<Choice> c = choose(header.channels())) {
            c->part = i;
            c->lumaChroma = c->lumaChroma && file.parts() == 1;
            return *c;
        }
    }
    source.unsupported("EXR without a flat layer that has R, G and B or Y");
}

size_t widthOf(const Box2i& b) { return size_t(b.max.x - b.min.x + 1); }
size_t heightOf(const Box2i& b) { return size_t(b.max.y - b.min.y + 1); }

void readChannels(Imf::MultiPartInputFile& file, const Choice& choice, const Box2i& window,
                  Image& image, const ImageSource& source) {
    Imf::InputPart part(file, choice.part);
    const size_t width = widthOf(window);
    Imf::FrameBuffer frame;
    for (int i = 0; i < 4; ++i) {
        const Imf::Channel* channel = file.header(choice.part).channels().findChannel(
            choice.channels[i]);
        if (i > 0 && i < 3 && choice.channels[i] == choice.channels[0]) continue;  // Y alone
        if (channel && (channel->xSampling != 1 || channel->ySampling != 1))
            source.unsupported("EXR with the subsampled channel '" + choice.channels[i] + "'");
        frame.insert(choice.channels[i],
                     Imf::Slice::Make(Imf::FLOAT, image.floats() + i, window, 16, width * 16, 1, 1,
                                      i == 3 ? 1.0 : 0.0));
    }
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
    if (choice.channels[1] != choice.channels[0]) return;
    for (size_t p = 0; p < width * heightOf(window); ++p)
        image.floats()[p * 4 + 1] = image.floats()[p * 4 + 2] = image.floats()[p * 4];
}

// Half precision is what files of this kind hold.
void readLumaChroma(const ImageSource& source, const Box2i& window, Image& image) {
    MemoryStream stream(source.bytes, source.label);
    Imf::RgbaInputFile file(stream, 0);
    const size_t width = widthOf(window);
    std::vector<Imf::Rgba> pixels(width * heightOf(window));
    // OpenEXR wants the address that pixel (0, 0) would have; the integer detour keeps this
    // from being pointer arithmetic outside of the array.
    const intptr_t offset = intptr_t(window.min.x) + intptr_t(window.min.y) * intptr_t(width);
    const uintptr_t base = reinterpret_cast<uintptr_t>(pixels.data()) -
                           uintptr_t(offset) * sizeof(Imf::Rgba);
    file.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(base), 1, width);
    file.readPixels(window.min.y, window.max.y);
    float* out = image.floats();
    for (const Imf::Rgba& p : pixels)
        for (const half h : {p.r, p.g, p.b, p.a}) *out++ = h;
}

// What lies outside of the data window is black and transparent.
Image cropToDisplay(Image&& image, const Box2i& data, const Box2i& display) {
    if (data == display) return std::move(image);
    Image out = allocateImage(uint32_t(widthOf(display)), uint32_t(heightOf(display)),
                              PixelFormat::rgba32f);
    const int x0 = std::max(data.min.x, display.min.x), x1 = std::min(data.max.x, display.max.x);
    const int y0 = std::max(data.min.y, display.min.y), y1 = std::min(data.max.y, display.max.y);
    if (x1 < x0) return out;
    for (int y = y0; y <= y1; ++y) {
        const size_t from = size_t(y - data.min.y) * image.width + size_t(x0 - data.min.x);
        const size_t to = size_t(y - display.min.y) * out.width + size_t(x0 - display.min.x);
        std::memcpy(out.floats() + to * 4, image.floats() + from * 4, size_t(x1 - x0 + 1) * 16);
    }
    return out;
}

}  // namespace

bool isExr(std::span<const std::byte> bytes) {
    constexpr unsigned char magic[4] = {0x76, 0x2f, 0x31, 0x01};
    return bytes.size() >= 4 && std::memcmp(bytes.data(), magic, 4) == 0;
}

Image decodeExr(const ImageSource& source) {
    checkExrHeader(source);
    try {
        MemoryStream stream(source.bytes, source.label);
        Imf::MultiPartInputFile file(stream, 0);
        const Choice choice = choosePart(file, source);
        const Box2i data = file.header(choice.part).dataWindow();
        const Box2i display = file.header(choice.part).displayWindow();
        Image image = allocateImage(uint32_t(widthOf(data)), uint32_t(heightOf(data)),
                                    PixelFormat::rgba32f);
        if (choice.lumaChroma) readLumaChroma(source, data, image);
        else readChannels(file, choice, data, image, source);
        return cropToDisplay(std::move(image), data, display);
    } catch (const FileError&) {
        throw;
    } catch (const std::exception& e) {
        // OpenEXR's own messages repeat the name and may have several lines: the last one counts.
        const std::string_view text = e.what();
        const size_t end = text.find_last_not_of('\n') + 1;
        const size_t line = text.substr(0, end).rfind('\n') + 1;  // npos + 1 is 0
        source.fail(std::string("damaged EXR: ").append(text.substr(line, end - line)));
    }
}

}  // namespace gp::io
