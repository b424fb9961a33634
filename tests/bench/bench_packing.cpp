// Why frames of films are packed by code of our own: sizes and times of it and of what libraries have, on the rows of
// PNG files, as they were before they were packed. bench_packing [--repeat N] FRAME.png…
#include "render/image_io/module/formats.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFile>
#include <QTextStream>
#include <QtEndian>

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

using namespace suffuse;

namespace {

using Bytes = std::vector<unsigned char>;

/// The filtered rows of a PNG file with one IDAT chunk of 3 × 8 bits a pixel, as ours have; empty for others.
Bytes rowsOf(const QByteArray &png)
{
    const auto number = [&](qsizetype at) { return std::size_t(qFromBigEndian<quint32>(png.constData() + at)); };
    constexpr qsizetype widthAt = 16, heightAt = 20;
    const qsizetype at = png.indexOf("IDAT");
    if (!png.startsWith("\x89PNG") || at < heightAt)
        return {};
    Bytes rows((number(widthAt) * 3 + 1) * number(heightAt));
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor *)> inflate(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    const auto result = libdeflate_zlib_decompress(inflate.get(), png.constData() + at + 4, number(at - 4), rows.data(),
                                                   rows.size(), nullptr);
    return result == LIBDEFLATE_SUCCESS ? rows : Bytes();
}

/// Packs `from` into `to`, which has room for all of it and more; returns the size.
using Pack = std::function<std::size_t(const Bytes &from, Bytes &to)>;

Pack byZlib(int level, int strategy)
{
    return [=](const Bytes &from, Bytes &to) {
        z_stream stream{};
        constexpr int windowBits = 15, memory = 9;
        deflateInit2(&stream, level, Z_DEFLATED, windowBits, memory, strategy);
        stream.next_in = const_cast<Bytef *>(from.data());
        stream.avail_in = uInt(from.size());
        stream.next_out = to.data();
        stream.avail_out = uInt(to.size());
        deflate(&stream, Z_FINISH);
        deflateEnd(&stream);
        return std::size_t(stream.total_out);
    };
}

Pack byLibdeflate(int level)
{
    return [level](const Bytes &from, Bytes &to) {
        const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor *)> compressor(
            libdeflate_alloc_compressor(level), libdeflate_free_compressor);
        return libdeflate_zlib_compress(compressor.get(), from.data(), from.size(), to.data(), to.size());
    };
}

std::size_t bytesOf(const std::vector<Bytes> &frames, const Pack &pack, Bytes &to)
{
    std::size_t bytes = 0;
    for (const Bytes &rows : frames)
        bytes += pack(rows, to);
    return bytes;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOption({"repeat", "Runs of each (default 9).", "N", "9"});
    parser.addPositionalArgument("FRAME.png", "Frames, as suffuse-cli timelapse writes them.", "FRAME.png...");
    parser.process(app);
    QTextStream out(stdout);
    std::vector<Bytes> frames;
    std::size_t raw = 0, most = 0;
    for (const QString &path : parser.positionalArguments()) {
        QFile file(path);
        frames.push_back(file.open(QIODevice::ReadOnly) ? rowsOf(file.readAll()) : Bytes());
        if (frames.back().empty()) {
            out << path << ": not a PNG file of 8 bits without alpha, as suffuse-cli timelapse writes them\n";
            return 1;
        }
        raw += frames.back().size();
        most = std::max(most, frames.back().size());
    }
    if (frames.empty())
        parser.showHelp(2);
    const std::vector<std::pair<const char *, Pack>> ways{
        {"packRuns", [](const Bytes &from, Bytes &to) { return packRuns(from.data(), from.size(), to.data()); }},
        {"zlib Z_RLE", byZlib(1, Z_RLE)},
        {"zlib Z_HUFFMAN_ONLY", byZlib(1, Z_HUFFMAN_ONLY)},
        {"zlib level 1", byZlib(1, Z_DEFAULT_STRATEGY)},
        {"libdeflate level 1", byLibdeflate(1)},
        {"libdeflate level 6", byLibdeflate(6)}};
    out << frames.size() << " frames, " << raw << " bytes\n";
    Bytes to(packedRunsBound(most) + most);
    std::vector<std::vector<double>> times(ways.size());
    const int repeat = std::max(1, parser.value("repeat").toInt());
    for (int run = 0; run < repeat; ++run) // in turn: what else the machine does meets all of them
        for (std::size_t k = 0; k < ways.size(); ++k) {
            const auto start = std::chrono::steady_clock::now();
            bytesOf(frames, ways[k].second, to);
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
            times[k].push_back(took.count() / double(frames.size()));
        }
    for (std::size_t k = 0; k < ways.size(); ++k) {
        std::sort(times[k].begin(), times[k].end());
        out << QString::asprintf("%-20s %10zu bytes a frame   %7.2f ms (least %.2f)\n", ways[k].first,
                                 bytesOf(frames, ways[k].second, to) / frames.size(), times[k][times[k].size() / 2],
                                 times[k].front());
    }
    return 0;
}
