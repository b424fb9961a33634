// Notebooks of Xournal++ become paintings: pages, layers, widths, colours, pictures, and what is said of damaged ones.
#include "model/formats/files.h"
#include "model/formats/gzip.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

const QByteArray line = "<stroke tool='pen' color='#ff0000ff' width='3'>30 60 60 60 90 60 120 60</stroke>";
const QByteArray marker = "<stroke tool='highlighter' color='#ffff00ff' width='9'>30 90 60 90 90 90</stroke>";

QByteArray page(const QByteArray &content)
{
    return "<page width='300' height='150'><background type='solid' color='#ffffffff' style='plain'/>" + content +
           "</page>";
}

QByteArray notebook(const QByteArray &pages)
{
    return "<?xml version=\"1.0\" standalone=\"no\"?>\n<xournal fileversion=\"4\">" + pages + "</xournal>";
}

/// A red pixel.
QByteArray image()
{
    return "<image left='30' top='15' right='60' bottom='45'>iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42m"
           "P4z8AAAAMBAQD3A0FDAAAAAElFTkSuQmCC</image>";
}

Result<LoadedDocument> opened(const QByteArray &xml)
{
    return readDocument(packedGzip(xml), QStringLiteral("a.ink"));
}

QString errorOf(const QByteArray &bytes)
{
    const Result<LoadedDocument> read = readDocument(bytes, QStringLiteral("a.ink"));
    return read ? QStringLiteral("no error") : read.error();
}

} // namespace

class TestInkXournal : public QObject {
    Q_OBJECT

private slots:
    /// A rectangle has five points. Its sides stay straight and its corners where they are.
    void linesBetweenFarPointsAreStraight()
    {
        const auto read = opened(notebook(page("<layer><stroke tool='pen' color='#000000ff' width='3'>30 30 180 30 180 "
                                               "105 30 105 30 30</stroke></layer>")));
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->painting.strokes.size(), std::size_t(1));
        const Stroke &s = *read->painting.strokes[0];
        QVERIFY(s.segments.size() < 80);
        const std::vector<Point> corners{{40, 40}, {240, 40}, {240, 140}, {40, 140}};
        std::vector<double> nearest(corners.size(), 1e9);
        double farthest = 0;
        for (const Segment &segment : s.segments) {
            const Cubic curve = offsetsOf(segment);
            for (int k = 0; k <= 16; ++k) {
                const Point p = s.origin + curve.at(k / 16.0);
                // from the nearest side
                const double x = std::min(std::abs(p.x - 40), std::abs(p.x - 240));
                const double y = std::min(std::abs(p.y - 40), std::abs(p.y - 140));
                farthest = std::max(farthest, std::min(x, y));
                for (std::size_t i = 0; i < corners.size(); ++i)
                    nearest[i] = std::min(nearest[i], length(p - corners[i]));
            }
        }
        QVERIFY2(farthest < 0.6, qPrintable(QString::number(farthest)));
        for (const double distance : nearest)
            QVERIFY2(distance < 0.3, qPrintable(QString::number(distance)));
    }

    void layersAreGroups()
    {
        const auto read = opened(notebook(page("<layer name='Red'>" + line + "</layer><layer>" + image() + marker +
                                               "<text x='1' y='1'>words</text></layer>")));
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(int(read->format), int(FileFormat::Xournal));
        const Painting &painting = read->painting;
        QCOMPARE(painting.canvas.width, 400.0);
        QCOMPARE(painting.canvas.height, 200.0);
        QCOMPARE(painting.groups.size(), std::size_t(2));
        QCOMPARE(painting.groups[0].name, QStringLiteral("Red"));
        QCOMPARE(painting.groups[1].name, QStringLiteral("Layer 2"));
        QCOMPARE(painting.strokes.size(), std::size_t(3));
        const Stroke &red = *painting.strokes[0];
        QCOMPARE(red.group, painting.groups[0].id);
        const Point start = red.origin + red.segments.front().bezier[0];
        QVERIFY(length(start - Point{40, 80}) < 1e-3);
        const Colour expected = rybFromSrgb(1, 0, 0, 1);
        QCOMPARE(red.segments.front().colour.yellow, expected.yellow);
        QCOMPARE(red.segments.front().colour.opacity, 1.f);
        QVERIFY(painting.strokes[1]->picture);
        QCOMPARE(painting.strokes[2]->segments.front().colour.opacity, float(120.0 / 255));
        QVERIFY2(read->leftOut.startsWith(QLatin1String("1 text")), qPrintable(read->leftOut));
    }

    void pagesLieBelowEachOther()
    {
        const auto read = opened(notebook(page("<layer>" + line + "</layer>") + page("<layer>" + line + "</layer>")));
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->painting.canvas.height, 420.0);
        QCOMPARE(read->painting.groups.size(), std::size_t(4));
        QCOMPARE(read->painting.groups[2].name, QStringLiteral("Page 2"));
        QCOMPARE(read->painting.groups[3].parent, read->painting.groups[2].id);
        const Stroke &below = *read->painting.strokes[1];
        QVERIFY(length(below.origin + below.segments.front().bezier[0] - Point{40, 300}) < 1e-3);
    }

    /// A pen that was pressed has a width for each piece; a wider line spreads further.
    void widthsFollow()
    {
        const auto spread = [](const QByteArray &width) {
            const auto read = opened(notebook(page("<layer><stroke tool='pen' color='blue' width='" + width +
                                                   "'>30 60 60 60 90 60 120 60</stroke></layer>")));
            return read ? read->painting.strokes.at(0)->segments : std::vector<Segment>();
        };
        const auto thin = spread("1"), thick = spread("3"), pressed = spread("2 1 2 3");
        QVERIFY(!thin.empty() && !thick.empty() && !pressed.empty());
        // The spread is the root of the diffusion times the age, which is the same for all.
        QVERIFY(std::abs(std::sqrt(thick.front().diffusion / thin.front().diffusion) - 3) < 1e-3);
        QVERIFY(pressed.back().diffusion > 2 * pressed.front().diffusion);
    }

    void wrongNumbersArePlaced()
    {
        for (const char *bad : {"nan", "inf", "1e400", "1e8", "x"}) {
            QByteArray wrong = line;
            wrong.replace("90 60", QByteArray(bad) + " 60");
            const QString error = errorOf(notebook(page("<layer>" + wrong + "</layer>")));
            QVERIFY2(error.startsWith(QLatin1String("a.ink: line 2, column ")) && error.contains(QLatin1String(bad)),
                     qPrintable(error));
        }
        QVERIFY(errorOf(notebook(page("<layer><stroke width='1'>1 2 3</stroke></layer>"))).contains("x without y"));
        QVERIFY(errorOf(notebook("")).contains("no pages"));
        QVERIFY(errorOf(notebook(page(""))).contains("no pen strokes"));
    }

    void bombsAreRefused()
    {
        const QByteArray head = "<xournal><page width='1' height='1'>";
        QVERIFY(errorOf(packedGzip(head + QByteArray(70 << 20, ' '))).contains("too large once it is unpacked"));
    }

    void damagedOnesEnd()
    {
        const QByteArray xml = notebook(page("<layer name='a'>" + line + marker + image() + "</layer>") +
                                        page("<layer>" + line + "</layer>"));
        QRandomGenerator random(1);
        int paintings = 0;
        for (int k = 0; k < 2000; ++k) {
            QByteArray damaged = k % 4 == 0 ? packedGzip(xml) : xml;
            for (int n = 0; n < 3; ++n)
                damaged[random.bounded(int(damaged.size()))] =
                    k % 2 ? "0123456789 .-<>/'e"[random.bounded(18)] : char(random.bounded(256));
            const auto read = readDocument(damaged, QStringLiteral("a.ink"));
            if (read)
                QCOMPARE(problemOf(read->painting), QString());
            else
                QVERIFY2(read.error().startsWith(QLatin1String("a.ink: ")), qPrintable(read.error()));
            paintings += bool(read);
        }
        QVERIFY2(paintings > 20, qPrintable(QString::number(paintings)));
    }
};

QTEST_GUILESS_MAIN(TestInkXournal)
#include "test_ink_xournal.moc"
