// Diffusion curves come in as strokes along both sides.
#include "model/formats/files.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QFile>
#include <QTest>

using namespace suffuse;

namespace {

/// A straight curve from (10, 40) to (70, 40) in a picture of 100 × 80, in the file's order (row, column; blue first).
QByteArray curve(const QByteArray &blur = "<best_scale value=\"0\" globalID=\"0\"/>")
{
    return "<!DOCTYPE CurveSetXML><curve_set image_width=\"100\" image_height=\"80\" "
           "nb_curves=\"1\"><curve><control_points_set>"
           "<control_point x=\"40\" y=\"10\"/><control_point x=\"40\" y=\"30\"/><control_point x=\"40\" y=\"50\"/>"
           "<control_point x=\"40\" y=\"70\"/></control_points_set><left_colors_set>"
           "<left_color R=\"0\" G=\"0\" B=\"255\" globalID=\"0\"/><left_color R=\"255\" G=\"0\" B=\"0\" "
           "globalID=\"10\"/>"
           "</left_colors_set><right_colors_set><right_color R=\"0\" G=\"255\" B=\"0\" "
           "globalID=\"4\"/></right_colors_set>"
           "<blur_points_set>" +
           blur + "</blur_points_set></curve></curve_set>";
}

Painting read(const QByteArray &bytes)
{
    const Result<Painting> painting = readPainting(bytes, QStringLiteral("a.xml"));
    if (!painting)
        qWarning("%s", qPrintable(painting.error()));
    return painting ? *painting : Painting();
}

QString errorOf(const QByteArray &bytes)
{
    const Result<Painting> painting = readPainting(bytes, QStringLiteral("a.xml"));
    return painting ? QString() : painting.error();
}

} // namespace

class TestDiffusionCurves : public QObject {
    Q_OBJECT

private slots:
    void edgesMeetOnTheCurve()
    {
        const Painting painting = read(curve());
        QCOMPARE(painting.canvas.width, 100.0);
        QCOMPARE(painting.canvas.height, 80.0);
        QCOMPARE(painting.strokes.size(), std::size_t(2));
        QCOMPARE(problemOf(painting), QString());
        double rows = 0;
        for (const StrokePtr &stroke : painting.strokes) {
            const Segment &segment = stroke->segments.front();
            const Point start = stroke->origin + segment.bezier[0];
            QCOMPARE(start.x, 10.0);
            const double half = halfWidth(double(segment.diffusion), double(segment.density), double(segment.maxAge),
                                          visibleCut(stroke->style));
            QVERIFY2(std::abs(std::abs(start.y - 40) - half) < 1e-4, qPrintable(QString::number(half)));
            rows += start.y - 40;
        }
        QVERIFY(std::abs(rows) < 1e-9); // one on each side
    }

    void coloursChangeAlongTheirSide()
    {
        const Painting painting = read(curve());
        const Stroke *left = nullptr, *right = nullptr;
        for (const StrokePtr &stroke : painting.strokes)
            (stroke->segments.front().colour == stroke->segments.back().colour ? right : left) = stroke.get();
        QVERIFY(left && right);
        const auto first = srgbFromRyb(left->segments.front().colour), last = srgbFromRyb(left->segments.back().colour);
        QVERIFY(first[0] > 0.8 && first[2] < 0.2); // red to blue
        QVERIFY(last[0] < 0.2 && last[2] > 0.8);
        QVERIFY(srgbFromRyb(right->segments.front().colour)[1] > 0.99);
    }

    void blurSoftensWhereItIs()
    {
        const Painting painting =
            read(curve("<best_scale value=\"0\" globalID=\"0\"/><best_scale value=\"0.3\" globalID=\"10\"/>"));
        const Stroke &stroke = *painting.strokes.front();
        const double first = double(stroke.styleOf(stroke.segments.front()).xi[1]);
        const double last = double(stroke.styleOf(stroke.segments.back()).xi[1]);
        QVERIFY2(last > 2 * first, qPrintable(QStringLiteral("%1 %2").arg(first).arg(last)));
    }

    void mistakesNameTheLine()
    {
        QVERIFY(errorOf("<curve_set image_width=\"9\">\n</curve_set>").startsWith("a.xml: line 1: image_height"));
        QVERIFY(errorOf("<curve_set image_width=\"9\" image_height=\"9\"/>").contains("no curves"));
        QVERIFY(errorOf(curve().replace("y=\"70\"", "y=\"nan\"")).contains("line 1: y of control_point"));
        QVERIFY(errorOf(curve().replace("<control_point x=\"40\" y=\"30\"/>", "")).contains("3 control points"));
        QVERIFY(errorOf(curve().replace("right_color ", "other ")).contains("no colours"));
        QVERIFY(errorOf(curve().chopped(20)).contains("line 1"));
    }

    void realPictures_data()
    {
        QTest::addColumn<int>("curves");
        QTest::newRow("poivron.xml") << 38;
        QTest::newRow("zephyr.xml") << 87;
    }
    void realPictures()
    {
        QFETCH(const int, curves);
        QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/diffusion_curves/") + QTest::currentDataTag());
        if (!file.open(QIODevice::ReadOnly))
            QSKIP("needs ../shared/data/diffusion_curves");
        const Painting painting = read(file.readAll());
        QCOMPARE(painting.strokes.size(), std::size_t(2 * curves));
        QCOMPARE(problemOf(painting), QString());
    }
};

QTEST_GUILESS_MAIN(TestDiffusionCurves)
#include "test_diffusion_curves.moc"
