// Films: what is written is what was drawn, and nothing is left of one that is not finished.
#include "render/film/film_writer.h"
#include "render/threads/parallel.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <webp/demux.h>

using namespace suffuse;

namespace {

constexpr int width = 41, height = 26; // odd and even

/// A square that wanders over a ground; frames 4 to 6 are the same.
FloatPicture frameOf(std::size_t i, bool alpha)
{
    FloatPicture picture;
    picture.resize(width, height);
    const int at = int(i >= 4 && i <= 6 ? 4 : i) * 3;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool inside = x >= at && x < at + 7 && y >= 5 && y < 14;
            float *p = picture.rgba.data() + (std::size_t(y) * width + std::size_t(x)) * 4;
            p[0] = inside ? 1 : float(x) / 64;
            p[1] = inside ? 0.25f : float(y) / 64;
            p[2] = 0.5f;
            p[3] = alpha && !inside ? 0.0f : 1.0f;
        }
    return picture;
}

struct ShownFrame {
    FloatPicture picture;
    int milliseconds = 0;
};

/// An animated WebP as a viewer shows it.
struct Animation {
    bool alpha = false;
    WebPAnimInfo info{};
    std::vector<ShownFrame> frames;

    explicit Animation(const QByteArray &file)
    {
        const WebPData bytes{reinterpret_cast<const std::uint8_t *>(file.constData()), std::size_t(file.size())};
        const std::unique_ptr<WebPAnimDecoder, void (*)(WebPAnimDecoder *)> decoder(WebPAnimDecoderNew(&bytes, nullptr),
                                                                                    WebPAnimDecoderDelete);
        if (!decoder || !WebPAnimDecoderGetInfo(decoder.get(), &info))
            return;
        alpha = WebPDemuxGetI(WebPAnimDecoderGetDemuxer(decoder.get()), WEBP_FF_FORMAT_FLAGS) & ALPHA_FLAG;
        std::uint8_t *pixels = nullptr;
        for (int before = 0, end = 0; WebPAnimDecoderGetNext(decoder.get(), &pixels, &end); before = end) {
            ShownFrame shown;
            shown.picture.resize(int(info.canvas_width), int(info.canvas_height));
            std::transform(pixels, pixels + shown.picture.rgba.size(), shown.picture.rgba.begin(),
                           [](std::uint8_t v) { return float(v) / 255; });
            shown.milliseconds = end - before;
            frames.push_back(std::move(shown));
        }
    }
};

/// Colours count as far as they are seen.
float farthest(const FloatPicture &a, const FloatPicture &b)
{
    if (a.rgba.size() != b.rgba.size())
        return 99;
    float most = 0;
    for (std::size_t k = 0; k < a.rgba.size(); k += 4) {
        most = std::max(most, std::abs(a.rgba[k + 3] - b.rgba[k + 3]));
        for (std::size_t c = k; c < k + 3; ++c)
            most = std::max(most, std::abs(a.rgba[c] * a.rgba[k + 3] - b.rgba[c] * b.rgba[k + 3]));
    }
    return most;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestFilm : public QObject {
    Q_OBJECT

private slots:
    void kindsByTheName()
    {
        QCOMPARE(filmKindOf("a/%05d.png"), FilmKind::Frames);
        QCOMPARE(filmKindOf("a/%d.webp"), FilmKind::Frames);
        QCOMPARE(filmKindOf("a/film.WEBP"), FilmKind::WebP);
        QCOMPARE(filmKindOf("a/film.webm"), FilmKind::Video);
        QCOMPARE(filmKindOf("a/film.mp4"), FilmKind::Video);
        QCOMPARE(filmKindOf("a%b/film.mp4"), FilmKind::Video);
        const auto problem = [](const QString &path, bool alpha = false, int side = 10, double fps = 25) {
            FilmOptions options{path, 1, fps, side, side, {}};
            options.image.alpha = alpha;
            return problemOf(options);
        };
        QVERIFY(problem("a/frame.png").contains("%05d"));
        QVERIFY(problem("a/%d-%d.png").contains("%05d"));
        QVERIFY(problem("a/%d.gif").contains("gif") || !problem("a/%d.gif").isEmpty());
        QVERIFY(problem("a/film.mp4", true).contains("WebM"));
        QVERIFY(problem("a/film.webm", true).isEmpty());
        QVERIFY(!problem("a/film.webp", false, 20'000).isEmpty());
        QVERIFY(!problem("a/film.webm", false, 20'000).isEmpty());
        QVERIFY(!problem("a/film.webm", false, 10, 0).isEmpty());
    }

    void webpHoldsEveryFrame_data()
    {
        QTest::addColumn<bool>("alpha");
        QTest::addColumn<int>("quality");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("lossless") << false << 100 << 1.01 / 510;
        QTest::newRow("lossless, transparent") << true << 100 << 1.01 / 510;
        QTest::newRow("lossy") << false << 95 << 0.6; // colours are shared by four pixels
        QTest::newRow("lossy, transparent") << true << 95 << 0.6;
    }

    void webpHoldsEveryFrame()
    {
        QFETCH(bool, alpha);
        QFETCH(int, quality);
        QFETCH(double, tolerance);
        const QString path = m_folder.filePath("film.webp");
        FilmOptions options{path, 10, 30, width, height, {}};
        options.image.alpha = alpha;
        options.image.quality = quality;
        options.loops = !alpha;
        {
            const auto film = openFilm(options);
            QVERIFY2(film, qPrintable(film.error()));
            // In disorder, as from several threads.
            for (const std::size_t i : {1u, 0u, 3u, 2u, 4u, 7u, 6u, 5u, 9u, 8u})
                QVERIFY((*film)->write(i, frameOf(i, alpha)));
            QVERIFY(!QFile::exists(path) || !m_kept.isEmpty());
            QVERIFY((*film)->commit());
        }
        m_kept = contentOf(path);
        const Animation animation(m_kept);
        QCOMPARE(int(animation.info.canvas_width), width);
        QCOMPARE(int(animation.info.canvas_height), height);
        QCOMPARE(animation.alpha, alpha);
        QCOMPARE(animation.info.loop_count, alpha ? 1u : 0u);
        QCOMPARE(animation.frames.size(), std::size_t(8)); // the three that are the same are one
        int all = 0;
        for (std::size_t k = 0; k < 8; ++k) {
            const std::size_t i = k <= 4 ? k : k + 2;
            QVERIFY2(farthest(animation.frames[k].picture, frameOf(i, alpha)) <= float(tolerance),
                     qPrintable(QString::number(k)));
            all += animation.frames[k].milliseconds;
        }
        QCOMPARE(animation.frames[0].milliseconds, 33);
        QCOMPARE(animation.frames[4].milliseconds, 100);
        QCOMPARE(all, 333);
    }

    /// A ground that grows darker by a 255th a frame, which encoders of animations take for nothing.
    void webpHoldsWhatChangesSlowly()
    {
        constexpr int frames = 40;
        const QString path = m_folder.filePath("slow.webp");
        const auto film = openFilm({path, frames, 25, width, height, {}});
        QVERIFY2(film, qPrintable(film.error()));
        FloatPicture picture;
        picture.resize(width, height);
        for (int i = 0; i < frames; ++i) {
            std::fill(picture.rgba.begin(), picture.rgba.end(), 1 - float(i) / 255);
            picture.rgba[std::size_t(3 * width + i) * 4] = 0; // something else changes, too
            QVERIFY((*film)->write(std::size_t(i), picture));
        }
        QVERIFY((*film)->commit());
        const Animation animation(contentOf(path));
        QCOMPARE(animation.frames.size(), std::size_t(frames));
        const float *corner = animation.frames.back().picture.at(0, height - 1);
        for (int c = 0; c < 3; ++c)
            QVERIFY2(std::abs(corner[c] - picture.at(0, height - 1)[c]) < 3.5f / 255,
                     qPrintable(QString::number(corner[c])));
    }

    void unfinishedFilmsLeaveNothing()
    {
        QVERIFY(QDir(m_folder.path()).mkdir("left"));
        for (const QString name : {"left.webp", "left.webm", "left.mp4", "left/%03d.png"}) {
            if (filmKindOf(name) == FilmKind::Video && QStandardPaths::findExecutable("ffmpeg").isEmpty())
                continue;
            const QStringList before =
                QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
            {
                const auto film = openFilm({m_folder.filePath(name), 10, 25, width, height, {}});
                QVERIFY2(film, qPrintable(film.error()));
                for (std::size_t i = 0; i < 3; ++i)
                    QVERIFY((*film)->write(i, frameOf(i, false)));
            }
            QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot), before);
            QCOMPARE(QDir(m_folder.filePath("left")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                     QStringList());
            const auto nowhere = openFilm({m_folder.filePath("nowhere/" + name.section('/', -1)), 1, 25, 0, 0, {}});
            QVERIFY(!nowhere);
            QVERIFY2(nowhere.error().contains("nowhere does not exist"), qPrintable(nowhere.error()));
            QVERIFY(!QFileInfo::exists(m_folder.filePath("nowhere")));
        }
    }

    void videosByFfmpeg_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("alpha");
        QTest::newRow("WebM") << "film.webm" << false;
        QTest::newRow("WebM, transparent") << "clear.webm" << true;
        QTest::newRow("MP4") << "film.mp4" << false;
    }

    void videosByFfmpeg()
    {
        QFETCH(QString, name);
        QFETCH(bool, alpha);
        if (QStandardPaths::findExecutable("ffmpeg").isEmpty() || QStandardPaths::findExecutable("ffprobe").isEmpty())
            QSKIP("ffmpeg is not installed");
        const QString path = m_folder.filePath(name);
        FilmOptions options{path, 10, 12.5, width, height, {}};
        options.image.alpha = alpha;
        {
            const auto film = openFilm(options);
            QVERIFY2(film, qPrintable(film.error()));
            std::atomic<int> failed = 0;
            parallelFor(10, 2, [&](std::size_t i) { failed += (*film)->write(i, frameOf(i, alpha)) ? 0 : 1; });
            QCOMPARE(failed.load(), 0);
            QVERIFY(!QFile::exists(path));
            const Result<void> kept = (*film)->commit();
            QVERIFY2(kept, qPrintable(kept.error()));
        }
        QProcess probe;
        probe.start("ffprobe",
                    {"-v", "error", "-count_frames", "-show_entries",
                     "stream=width,height,nb_read_frames,avg_frame_rate,color_space", "-of", "csv=p=0", path});
        QVERIFY(probe.waitForFinished());
        const bool mp4 = name.endsWith("mp4");
        QCOMPARE(QString::fromLatin1(probe.readAllStandardOutput().trimmed()),
                 QString("%1,%2,bt709,25/2,10").arg(mp4 ? width + 1 : width).arg(height));
        // The last frame, decoded.
        QProcess decode;
        decode.start("ffmpeg",
                     QStringList{"-v", "error"} +
                         (name.endsWith("webm") ? QStringList{"-c:v", "libvpx-vp9"} : QStringList()) +
                         QStringList{"-i", path, "-vf", "select=eq(n\\,9)", "-f", "rawvideo", "-pix_fmt", "rgba", "-"});
        QVERIFY(decode.waitForFinished());
        const QByteArray pixels = decode.readAllStandardOutput();
        const int stride = mp4 ? width + 1 : width;
        QCOMPARE(pixels.size(), qsizetype(stride) * height * 4);
        const auto at = [&](int x, int y, int c) {
            return int((unsigned char)(pixels[(qsizetype(y) * stride + x) * 4 + c]));
        };
        QVERIFY(std::abs(at(30, 9, 0) - 255) < 24 && std::abs(at(30, 9, 1) - 64) < 24 &&
                std::abs(at(30, 9, 2) - 128) < 24);
        QVERIFY(std::abs(at(10, 9, 3) - (alpha ? 0 : 255)) < 4);
        QVERIFY(std::abs(at(30, 9, 3) - 255) < 4);
    }

    void whatFfmpegSaysIsPassedOn()
    {
        if (QStandardPaths::findExecutable("ffmpeg").isEmpty())
            QSKIP("ffmpeg is not installed");
        const QByteArray path = qgetenv("PATH");
        QFile fake(m_folder.filePath("ffmpeg"));
        QVERIFY(fake.open(QIODevice::WriteOnly));
        fake.write("#!/bin/sh\necho 'no encoder today' >&2\nexit 3\n");
        fake.close();
        fake.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", m_folder.path().toLocal8Bit() + ':' + path);
        {
            const auto film = openFilm({m_folder.filePath("bad.webm"), 10, 25, width, height, {}});
            QVERIFY(film);
            Result<void> outcome;
            for (std::size_t i = 0; i < 10 && outcome; ++i)
                outcome = (*film)->write(i, frameOf(i, false));
            if (outcome)
                outcome = (*film)->commit();
            QVERIFY(!outcome);
            QVERIFY2(outcome.error().contains("no encoder today"), qPrintable(outcome.error()));
        }
        QVERIFY(!QFile::exists(m_folder.filePath("bad.webm")));
        qputenv("PATH", "/nowhere");
        const auto none = openFilm({m_folder.filePath("bad.webm"), 10, 25, width, height, {}});
        QVERIFY(!none && none.error().contains("not installed"));
        qputenv("PATH", path);
        QFile::remove(fake.fileName());
    }

private:
    QTemporaryDir m_folder;
    QByteArray m_kept;
};

QTEST_GUILESS_MAIN(TestFilm)
#include "test_film.moc"
