// Notebooks of Rnote become paintings: order, widths, colours, curves of older versions, and what is said of damaged
// ones.
#include "model/formats/files.h"
#include "model/formats/gzip.h"
#include "model/formats/ink/recording.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

/// With ' for ".
QByteArray json(QByteArray text)
{
    return text.replace('\'', '"');
}

QByteArray stroke(const QByteArray &colour, const QByteArray &curve = "linear", const QByteArray &more = {})
{
    return "{'value':{'brushstroke':{'path':{'start':{'pos':[10,20],'pressure':0.25},'segments':["
           "{'lineto':{'end':{'pos':[20,24],'pressure':0.5}}},{'lineto':{'end':{'pos':[30,30],'pressure':1.0}}}]},"
           "'style':{'smooth':{'stroke_width':8.0,'stroke_color':" +
           colour + ",'fill_color':null,'pressure_curve':'" + curve + "'" + more + "}}}},'version':1}";
}

const QByteArray red = "{'r':1.0,'g':0.0,'b':0.0,'a':1.0}", blue = "{'r':0.0,'g':0.0,'b':1.0,'a':0.5}";

QByteArray notebook(const QByteArray &strokes, const QByteArray &chrono, const QByteArray &layout = "fixed_size",
                    const QByteArray &pattern = "none")
{
    return json(
        "{'version':'0.9.4','data':{'engine_snapshot':{'document':{'x':0.0,'y':0.0,'width':794.0,'height':1123.0,"
        "'background':{'color':{'r':1.0,'g':1.0,'b':1.0,'a':1.0},'pattern':'" +
        pattern + "'},'layout':'" + layout + "'},'stroke_components':[{'value':null,'version':0}," + strokes +
        "],'chrono_components':[{'value':null,'version':0}," + chrono + "],'chrono_counter':9}}}");
}

QByteArray at(const QByteArray &layer, int counter)
{
    return "{'value':{'t':" + QByteArray::number(counter) + ",'layer':" + layer + "},'version':1}";
}

QString errorOf(const QByteArray &text)
{
    const Result<LoadedDocument> read = readDocument(packedGzip(text), QStringLiteral("a.ink"));
    return read ? QStringLiteral("no error") : read.error();
}

} // namespace

class TestInkRnote : public QObject {
    Q_OBJECT

private slots:
    void widthsColoursAndPages()
    {
        const QByteArray text = notebook(stroke(red), at("{'user_layer':0}", 3));
        QCOMPARE(int(detectFormat(packedGzip(text))), int(FileFormat::Rnote));
        const auto read = readRnote(packedGzip(text), "a.rnote");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->paths.size(), std::size_t(1));
        const Recording::Path &path = read->paths[0];
        QCOMPARE(path.samples.front().position, (Point{10, 20}));
        QCOMPARE(path.samples.back().position, (Point{30, 30}));
        QCOMPARE(path.widths.front(), 2.0); // the pressure times the width
        QCOMPARE(path.widths.back(), 8.0);
        QVERIFY(path.colour && srgbFromRyb(*path.colour)[0] > 0.99);
        QCOMPARE(*read->area, Rect::of(0, 0, 794, 1123));
        QCOMPARE(read->leftOut, QString());
        const auto painting = readPainting(packedGzip(text), "a.rnote");
        QVERIFY(painting && painting->canvas.width == 794 && painting->strokes.size() == 1);
        QCOMPARE(problemOf(*painting), QString());
    }

    void curvesOfPressure()
    {
        const auto width = [](const char *curve) {
            return readRnote(notebook(stroke(red, curve), at("{'user_layer':0}", 3)), "a.rnote")
                ->paths[0]
                .widths.front();
        };
        QCOMPARE(width("const"), 8.0);
        QCOMPARE(width("linear"), 2.0);
        QCOMPARE(width("sqrt"), 4.0);
        QVERIFY(std::abs(width("cbrt") - 8 * std::cbrt(0.25)) < 1e-12);
        QCOMPARE(width("pow2"), 0.5);
        QCOMPARE(width("pow3"), 0.125);
    }

    /// Markers lie below what was written, whenever they came.
    void layersComeBeforeTheOrder()
    {
        const auto read = readRnote(
            notebook(stroke(red) + "," + stroke(blue) + "," + stroke(red),
                     at("{'user_layer':0}", 3) + "," + at("'highlighter'", 9) + "," + at("{'user_layer':0}", 1)),
            "a.rnote");
        QVERIFY(read && read->paths.size() == 3);
        const auto isBlue = [&](std::size_t k) { return srgbFromRyb(*read->paths[k].colour)[2] > 0.5; };
        QVERIFY(isBlue(0) && !isBlue(1) && !isBlue(2));
        QVERIFY(std::abs(double(read->paths[0].colour->opacity) - 0.5) < 1e-6);
    }

    void whatIsLeftOutIsSaid()
    {
        const auto read = readRnote(notebook(stroke(red, "linear", ",'line_style':'dotted'") +
                                                 ",{'value':{'textstroke':{'text':'a'}}},{'value':{'shapestroke':{}}},"
                                                 "{'value':{'bitmapimage':{}}}",
                                             at("{'user_layer':0}", 3), "infinite", "dots"),
                                    "a.rnote");
        QVERIFY(read && read->paths.size() == 1);
        for (const char *what : {"1 text", "1 shape", "1 image", "1 ruled"})
            QVERIFY2(read->leftOut.contains(what), qPrintable(read->leftOut));
        QVERIFY(!read->area); // paper without an end is as large as what is on it
    }

    /// Before version 0.5.9 a path was a list of curves, names were other letters, and what was deleted stayed.
    void olderNotebooks()
    {
        const QByteArray path =
            "[{'dot':{'element':{'pos':[0,0],'pressure':0.5}}},{'line':{'start':{'pos':[0,0],'pressure':"
            "0.5},'end':{'pos':[10,0],'pressure':0.5}}},{'cubbez':{'start':{'pos':[10,0],'pressure':0.5},"
            "'cp1':[20,0],'cp2':[30,10],'end':{'pos':[30,20],'pressure':1.0}}}]";
        const QByteArray one = "{'value':{'brushstroke':{'path':" + path +
                               ",'style':{'smooth':{'stroke_width':2.0,'stroke_color':" + red +
                               ",'fill_color':null,'pressure_curve':'const'}}}},'version':1}";
        const auto read =
            readRnote(json("{'version':'0.5.5','data':{'document':{'x':0.0,'y':0.0,'width':100.0,'height':100.0,'"
                           "layout':'fixed_size',"
                           "'background':{'color':" +
                           red + ",'pattern':'none'}},'store_snapshot':{'stroke_components':[" + one + "," + one +
                           "],'chrono_components':[" + at("{'UserLayer':0}", 1) + "," + at("{'UserLayer':0}", 2) +
                           "],'trash_components':[{'value':{'trashed':false}},{'value':{'trashed':true}}]}}}"),
                      "a.rnote");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->paths.size(), std::size_t(1));
        const auto &samples = read->paths[0].samples;
        QCOMPARE(samples.back().position, (Point{30, 20}));
        QVERIFY(std::ranges::any_of(samples, [](const PenSample &s) {
            return length(s.position - Point{23.75, 6.25}) < 1e-9;
        }));
        QVERIFY(read->background && srgbFromRyb(*read->background)[0] > 0.99);
        QCOMPARE(read->area->width(), 100.0);
    }

    void damagedNotebooksSayWhere()
    {
        QVERIFY(errorOf(json("{'version':'0.4.0','data':{'document':{}}}")).contains("0.5"));
        const QByteArray far = notebook(stroke(red).replace("[30,30]", "[30,1e9]"), at("{'user_layer':0}", 1));
        QVERIFY2(errorOf(far).contains("stroke_components[1]"), qPrintable(errorOf(far)));
        QVERIFY(errorOf(notebook(stroke(red), at("{'user_layer':0}", 1)).left(600)).contains("line 1"));
        QVERIFY(!errorOf(notebook("{'value':{}}", at("1", 1))).contains("no error"));
        const QByteArray whole = notebook(stroke(red) + "," + stroke(blue), at("{'user_layer':0}", 1));
        QRandomGenerator random(1);
        for (int k = 0; k < 500; ++k) {
            QByteArray bytes = whole;
            for (int i = 0; i < 3; ++i)
                bytes[random.bounded(int(bytes.size()))] = char(random.bounded(32, 127));
            const auto read = readPainting(k % 2 ? bytes : packedGzip(bytes), "a.ink");
            QVERIFY(!read || problemOf(*read).isEmpty());
        }
    }
};

QTEST_GUILESS_MAIN(TestInkRnote)
#include "test_ink_rnote.moc"
