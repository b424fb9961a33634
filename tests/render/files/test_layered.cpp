// Layered files: what plain programs make of the layers is the picture, and the painting comes back.
#include "tests/files.h"
#include "tests/render/layers/grouped.h"

#include "model/formats/files.h"
#include "model/formats/ora/ora_parts.h"
#include "render/layered/ora_file.h"
#include "tests/trials.h"

#include <QTemporaryDir>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// A separable mode as W3C Compositing 1 has it, on an opaque backdrop; written apart from the renderer.
double blended(BlendMode mode, double below, double above)
{
    const auto hardLight = [](double b, double s) { return s <= 0.5 ? b * 2 * s : b + (2 * s - 1) - b * (2 * s - 1); };
    switch (mode) {
    case BlendMode::Multiply:
        return below * above;
    case BlendMode::Screen:
        return below + above - below * above;
    case BlendMode::Overlay:
        return hardLight(above, below);
    case BlendMode::Darken:
        return std::min(below, above);
    case BlendMode::Lighten:
        return std::max(below, above);
    case BlendMode::HardLight:
        return hardLight(below, above);
    case BlendMode::Difference:
        return std::abs(below - above);
    default:
        return above;
    }
}

/// Puts layers on each other as other programs do: in whole levels, or in numbers that are not rounded.
class Flattener : public LayerSink {
public:
    Flattener(int width, int height, int bits)
        : m_width(width), m_most(bits == 8 ? 255 : 65535), m_rounded(std::size_t(width) * std::size_t(height) * 3),
          m_smooth(m_rounded.size()), exact(m_rounded.size())
    {}

    Result<void> beginFolder(const PlannedLayer &folder) override
    {
        names << folder.name + '(';
        return {};
    }
    Result<void> endFolder() override
    {
        names << QStringLiteral(")");
        return {};
    }
    Result<void> layer(const PlannedLayer &layer, const LevelPixels &pixels) override
    {
        names << layer.name + (layer.visible ? QString() : QStringLiteral(" hidden"));
        modes.push_back(layer.blend);
        for (int y = 0; y < pixels.rect.height && layer.visible; ++y)
            for (int x = 0; x < pixels.rect.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const std::size_t at = place(pixels.rect.x + x, pixels.rect.y + y, c);
                    const double colour = double(pixels.at(x, y, c));
                    const double a = double(pixels.at(x, y, 3)) * double(layer.opacity);
                    for (double *below : {&m_rounded[at], &m_smooth[at]})
                        *below += a * (blended(layer.blend, *below, colour) - *below);
                    m_rounded[at] = std::round(m_rounded[at] * m_most) / m_most;
                }
        return {};
    }
    Result<void> picture(const LevelPixels &pixels) override
    {
        for (int y = 0; y < pixels.rect.height; ++y)
            for (int x = 0; x < pixels.rect.width; ++x)
                for (int c = 0; c < 3; ++c)
                    exact[place(x, y, c)] = double(pixels.at(x, y, c));
        return {};
    }

    /// The greatest distance of what came out, and of the picture that was handed out, from a picture: of 8 bits as all
    /// of them are in whole levels.
    double distance(const FloatPicture &picture) const
    {
        const auto level = [this](double value) { return m_most > 255 ? value : std::round(value * 255) / 255; };
        double greatest = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const std::size_t at = place(x, y, c);
                    const double wanted = level(double(picture.at(x, y)[c]));
                    for (const double got : {m_rounded[at], m_smooth[at], exact[at]})
                        greatest = std::max(greatest, std::abs(level(got) - wanted));
                }
        return greatest;
    }

    QStringList names;
    std::vector<BlendMode> modes;

private:
    std::size_t place(int x, int y, int c) const
    {
        return (std::size_t(y) * std::size_t(m_width) + std::size_t(x)) * 3 + std::size_t(c);
    }

    int m_width;
    double m_most;
    std::vector<double> m_rounded, m_smooth;

public:
    std::vector<double> exact;
};

LayeredRequest requestFor(const PaintingPtr &painting, const View &view, int bits)
{
    LayeredRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = view;
    request.bits = bits;
    return request;
}

PaintingPtr sample(const QString &name)
{
    Result<Painting> loaded =
        loadPainting(QStringLiteral(SUFFUSE_SOURCE_DIR "/packaging/samples/%1.suffuse").arg(name));
    return loaded ? std::make_shared<const Painting>(std::move(*loaded)) : nullptr;
}

const QStringList samples = {"flat", "ink-landscape", "lanterns", "moonrise", "sheet", "still-life"};

} // namespace

class TestLayered : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

    /// Draws layers, and checks what plain programs make of them. Returns the stats.
    LayeredStats check(const PaintingPtr &painting, const View &view, int bits, Flattener &flattener,
                       const QString &name)
    {
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        const Result<LayeredStats> stats = drawLayers(requestFor(painting, view, bits), *renderer, *groups, flattener);
        if (!stats) {
            QTest::qFail(qPrintable(stats.error()), __FILE__, __LINE__);
            return {};
        }
        const double limit = bits == 8 ? 1.001 / 255 : 1.0 / 4096;
        const double distance = flattener.distance(test::render(*m_cpu, painting, view));
        if (distance > limit || stats->greatestDifference > (bits == 8 ? 1.0 / 255 : 1.0 / 4096))
            QTest::qFail(qPrintable(QStringLiteral("%1, %2 bits: %3 levels of 8 bits, %4 in whole levels")
                                        .arg(name)
                                        .arg(bits)
                                        .arg(distance * 255)
                                        .arg(stats->greatestDifference * 255)),
                         __FILE__, __LINE__);
        return *stats;
    }

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void samplesAreTheirPicture()
    {
        for (const QString &name : samples)
            for (const int bits : {8, 16}) {
                const PaintingPtr painting = sample(name);
                QVERIFY(painting);
                const Rect area = painting->canvas.area();
                const View view = View::ofArea(area, 160, int(std::lround(160 * area.height() / area.width())));
                Flattener flattener(view.width, view.height, bits);
                const LayeredStats stats = check(painting, view, bits, flattener, name);
                QVERIFY(stats.layers >= 2);
            }
    }

    void randomTreesAreTheirPicture()
    {
        const int trees = trials(60, 1000);
        std::size_t layers = 0, groups = 0;
        for (int i = 0; i < trees; ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i) + 400);
            auto p = std::make_shared<Painting>(*grouped(painting(randomStrokes(random, 14, 96, 72), 96, 72), random));
            if (i % 2)
                for (Group &g : p->groups)
                    g.clips = g.mask = false, g.opacity = 1 - float(random() % 3) / 4;
            p->canvas.background = {0.1f * float(i % 4), 0.2f, 0, i % 5 ? 1.0f : 0.5f};
            Flattener flattener(96, 72, i % 3 ? 8 : 16);
            const LayeredStats stats = check(p, View::ofArea(Rect::of(0, 0, 96, 72), 96, 72), i % 3 ? 8 : 16, flattener,
                                             QStringLiteral("tree %1").arg(i));
            layers += stats.layers;
            groups +=
                std::size_t(std::ranges::count_if(flattener.modes, [](BlendMode m) { return m != BlendMode::Normal; }));
        }
        // Some layers of each tree are asked for, and a group now and then, where there are trees enough to tell.
        QVERIFY2(layers >= 2 * std::size_t(trees), qPrintable(QString::number(layers)));
        QVERIFY2(trees < 60 || groups >= std::size_t(trees) / 12, qPrintable(QString::number(groups)));
    }

    /// What is clipped to something hidden is not seen, whatever lies below that; a group is hidden by its eye, or by
    /// those of its strokes.
    void clippedToWhatIsHidden()
    {
        for (const bool byGroup : {true, false}) {
            std::mt19937_64 random(9);
            auto p = std::make_shared<Painting>(*painting(randomStrokes(random, 12, 96, 72), 96, 72));
            for (GroupId id = 1; id <= 3; ++id) {
                Group group;
                group.id = id;
                group.clips = id == 3;
                group.visible = id != 2 || !byGroup;
                p->groups.push_back(group);
            }
            for (std::size_t i = 0; i < p->strokes.size(); ++i) {
                Stroke stroke = *p->strokes[i];
                stroke.group = 1 + i / 4;
                stroke.visible = byGroup || stroke.group != 2;
                p->strokes[i] = std::make_shared<const Stroke>(stroke);
            }
            for (const int bits : {8, 16}) {
                Flattener flattener(96, 72, bits);
                check(p, View::ofArea(Rect::of(0, 0, 96, 72), 96, 72), bits, flattener,
                      byGroup ? QStringLiteral("hidden group") : QStringLiteral("hidden strokes"));
            }
        }
    }

    /// A mask that is clipped covers no more than what lies just below it, and not what lies above.
    void clippedMasks()
    {
        std::mt19937_64 random(9);
        auto p = std::make_shared<Painting>(*painting(randomStrokes(random, 12, 96, 72), 96, 72));
        for (GroupId id = 1; id <= 3; ++id) {
            Group group;
            group.id = id;
            group.clips = group.mask = id == 2;
            p->groups.push_back(group);
        }
        for (std::size_t i = 0; i < p->strokes.size(); ++i) {
            Stroke stroke = *p->strokes[i];
            stroke.group = 1 + i / 4;
            p->strokes[i] = std::make_shared<const Stroke>(stroke);
        }
        for (const int bits : {8, 16}) {
            Flattener flattener(96, 72, bits);
            check(p, View::ofArea(Rect::of(0, 0, 96, 72), 96, 72), bits, flattener, QStringLiteral("clipped mask"));
        }
    }

    void layersHaveTheirNamesAndPlaces()
    {
        auto p = std::make_shared<Painting>();
        p->canvas = {64, 48, {}, {}};
        const auto group = [&](GroupId id, GroupId parent, const QString &name) -> Group & {
            Group g;
            g.id = id, g.parent = parent, g.name = name;
            return p->groups.emplace_back(g);
        };
        group(1, 0, "folder");
        group(2, 1, "glow").blend = BlendMode::Screen;
        group(3, 0, "shown not").visible = false;
        group(4, 1, "plain");
        const auto add = [&](GroupId in, double x) {
            Stroke s = test::stroke(StrokeId(p->strokes.size() + 1), Shape::Straight, {x, 20}, 10, 3,
                                    styleOf(StyleKind::Uniform));
            s.group = in;
            p->strokes.push_back(std::make_shared<const Stroke>(s));
        };
        add(0, 8), add(1, 16), add(2, 24), add(4, 30), add(3, 36), add(0, 40);
        Flattener flattener(64, 48, 8);
        check(p, View::ofArea(p->canvas.area(), 64, 48), 8, flattener, "names");
        QCOMPARE(flattener.names, QStringList({"Background", "Strokes", "folder(", "Strokes", "glow", "plain", ")",
                                               "shown not hidden", "Strokes"}));
        QCOMPARE(std::ranges::count(flattener.modes, BlendMode::Screen), 1);
    }

    void nothingButABackground()
    {
        auto p = std::make_shared<Painting>();
        p->canvas = {20, 10, {0.2f, 0.1f, 0.7f, 1}, {}};
        Flattener flattener(20, 10, 8);
        QCOMPARE(check(p, View::ofArea(p->canvas.area(), 20, 10), 8, flattener, "bare").layers, std::size_t(1));
    }

    void thePaintingComesBack()
    {
        for (const QString &name : samples) {
            const PaintingPtr painting = sample(name);
            QVERIFY(painting);
            const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
            const QString file = path(name + ".ora");
            const auto written = writeOpenRaster(
                file, requestFor(painting, View::ofArea(painting->canvas.area(), 48, 36), 8), *renderer, *groups);
            QVERIFY2(written, qPrintable(written ? QString() : written.error()));
            const QByteArray bytes = bytesOf(file);
            QCOMPARE(detectFormat(bytes), FileFormat::OpenRaster);
            const Result<LoadedDocument> document = readDocument(bytes, file);
            QVERIFY2(document, qPrintable(document ? QString() : document.error()));
            QVERIFY(document->painting == *painting);
            QCOMPARE(hashOf(document->painting), hashOf(*painting));
            QCOMPARE(document->leftOut, QString());
            // The same painting makes the same bytes.
            QVERIFY(writeOpenRaster(path("again.ora"),
                                    requestFor(painting, View::ofArea(painting->canvas.area(), 48, 36), 8), *renderer,
                                    *groups));
            QVERIFY(bytesOf(path("again.ora")) == bytes);
        }
    }

    /// A picture that another program changed is told; a file that another program made comes in as its layers.
    void filesOfOthers()
    {
        const PaintingPtr painting = sample("flat");
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        QVERIFY(writeOpenRaster(path("a.ora"), requestFor(painting, View::ofArea(painting->canvas.area(), 32, 24), 8),
                                *renderer, *groups));
        QByteArray bytes = bytesOf(path("a.ora"));
        const qsizetype hash = bytes.indexOf("suffuse/mergedimage.sha256") + 26;
        QVERIFY(hash > 26);
        QByteArray changed = bytes;
        changed.replace(QByteArray("suffuse/painting.suffuse"), QByteArray("suffuse/Painting.suffuse"));
        const Result<LoadedDocument> without = readDocument(changed, "b.ora");
        QVERIFY(without && without->painting.strokes.size() > 1); // a picture for each layer
        QVERIFY(std::ranges::all_of(without->painting.strokes, [](const StrokePtr &s) { return bool(s->picture); }));
        changed = bytes;
        changed.replace(QByteArray("suffuse/mergedimage.sha256"), QByteArray("suffuse/mergedimage.sha257"));
        const Result<LoadedDocument> told = readDocument(changed, "c.ora");
        QVERIFY(told && told->painting == *painting);
        QVERIFY(told->leftOut.contains("Another program"));
    }

    /// Damaged files are refused in words, whatever is broken.
    void damagedFiles()
    {
        const PaintingPtr painting = sample("flat");
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        QVERIFY(writeOpenRaster(path("a.ora"), requestFor(painting, View::ofArea(painting->canvas.area(), 24, 18), 8),
                                *renderer, *groups));
        const QByteArray whole = bytesOf(path("a.ora"));
        const int files = trials(300, 2000);
        int refused = 0;
        for (int i = 0; i < files; ++i) {
            std::mt19937_64 random(firstSeed() + unsigned(i));
            QByteArray bytes = whole;
            const auto any = [&](qsizetype below) { return qsizetype(random() % std::uint64_t(below)); };
            if (i % 3 == 0)
                bytes.truncate(any(bytes.size()));
            for (std::uint64_t n = random() % 4; n > 0 && i % 3 != 0; --n)
                bytes[any(bytes.size())] = char(random());
            if (i % 3 == 2) // the list of parts, in the end
                bytes[bytes.size() - 1 - any(std::min<qsizetype>(bytes.size(), 600))] = char(random());
            const Result<LoadedDocument> document = readDocument(bytes, "damaged.ora");
            refused += !document;
            QVERIFY(document || !document.error().isEmpty());
        }
        QVERIFY2(refused >= files / 30, qPrintable(QString::number(refused)));
    }

    void stoppedWorkLeavesNothing()
    {
        const PaintingPtr painting = sample("lanterns");
        const auto renderer = make(Backend::Cpu), groups = make(Backend::Cpu);
        for (const std::size_t after : {std::size_t(1), std::size_t(9)}) {
            std::atomic<bool> cancel{false};
            LayeredRequest request = requestFor(painting, View::ofArea(painting->canvas.area(), 120, 160), 8);
            request.cancel = &cancel;
            request.progress = [&](std::size_t done, std::size_t) { cancel = done >= after; };
            const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
            const auto written = writeOpenRaster(path("stopped.ora"), request, *renderer, *groups);
            QVERIFY(!written);
            QVERIFY(written.error().contains("nothing"));
            QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        }
        const auto nowhere =
            writeOpenRaster(path("missing/a.ora"),
                            requestFor(painting, View::ofArea(painting->canvas.area(), 24, 32), 8), *renderer, *groups);
        QVERIFY(!nowhere && !nowhere.error().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestLayered)
#include "test_layered.moc"
