// InkML becomes paintings: values and differences of channels, units, brushes, groups, and what is said of damaged
// ones.
#include "model/formats/files.h"
#include "model/formats/ink/inkml_trace.h"
#include "model/formats/ink/recording.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

QByteArray ink(const QByteArray &content)
{
    return "<?xml version='1.0'?>\n<ink xmlns='http://www.w3.org/2003/InkML'>" + content + "</ink>";
}

/// A context as writing programs have it: hundredths of a millimetre, and forces up to 32767.
QByteArray context()
{
    return "<definitions><context xml:id='c'><inkSource xml:id='s'><traceFormat>"
           "<channel name='X' type='integer'/><channel name='Y' type='integer'/>"
           "<channel name='F' type='integer' max='32767'/><channel name='T' type='integer'/></traceFormat>"
           "<channelProperties><channelProperty channel='X' name='resolution' value='1000' units='1/cm'/>"
           "<channelProperty channel='Y' name='resolution' value='1000' units='1/cm'/></channelProperties></inkSource>"
           "</context><brush xml:id='b'><brushProperty name='width' value='0.254' units='cm'/>"
           "<brushProperty name='color' value='#FF0000'/><brushProperty name='transparency' value='127'/></brush>"
           "</definitions>";
}

Result<Recording> recordingOf(const QByteArray &content)
{
    return readInkml(ink(content), QStringLiteral("a.inkml"));
}

QString errorOf(const QByteArray &content)
{
    const Result<LoadedDocument> read = readDocument(ink(content), QStringLiteral("a.ink"));
    return read ? QStringLiteral("no error") : read.error();
}

using Values = std::vector<double>;

} // namespace

class TestInkInkml : public QObject {
    Q_OBJECT

private slots:
    /// The examples of the specification, and what writers make of its freedom to leave blanks out.
    void valuesOfTraces_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<Values>("values");
        QTest::newRow("plain") << QByteArray("1 2, 3 4,5 6") << Values{1, 2, 3, 4, 5, 6};
        QTest::newRow("differences") << QByteArray("1125 18432,'23'43,\"7\"-8,3-5")
                                     << Values{1125, 18432, 1148, 18475, 1178, 18510, 1211, 18540};
        QTest::newRow("back to values") << QByteArray("1 1,'2'2,!10!20,30 40") << Values{1, 1, 3, 3, 10, 20, 30, 40};
        QTest::newRow("as before") << QByteArray("1 2,* 5,?-6") << Values{1, 2, 1, 5, 1, -6};
        QTest::newRow("base 16 and fractions") << QByteArray("#1F .5,1e2-.25") << Values{31, 0.5, 100, -0.25};
        QTest::newRow("truth") << QByteArray("T F") << Values{1, 0};
        QTest::newRow("nothing") << QByteArray(" ") << Values{};
    }
    void valuesOfTraces()
    {
        QFETCH(QByteArray, text);
        QFETCH(Values, values);
        const auto read = traceValues({text.constData(), std::size_t(text.size())}, 2, 0, 100);
        QVERIFY(read.has_value());
        QCOMPARE(*read, values);
    }

    void damagedTraces()
    {
        for (const char *text : {"1", "1 2 3", "1 x", "1 2,3", "1 2,,3 4", "1e999 2", "1 2e15", "'"})
            QVERIFY2(!traceValues(text, 2, 0, 100), text);
        QVERIFY(!traceValues("1 2,3 4,5 6", 2, 0, 2)); // too many
        // Channels that come and go may lack, and are as before.
        QCOMPARE(traceValues("1 2 7,3 4,5 6 8", 3, 1, 100), (Values{1, 2, 7, 3, 4, 7, 5, 6, 8}));
        QVERIFY(!traceValues("1 2 7,3", 3, 1, 100));
    }

    void unitsPressuresAndTimes()
    {
        // 1000 are a centimetre, so 2540 are an inch, which has 96 units; times are in milliseconds.
        const auto read = recordingOf(context() + "<trace contextRef='#c' brushRef='#b' timeOffset='500'>"
                                                  "0 0 0 0,2540 0 16383.5 8,5080 2540 32767 16</trace>");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->paths.size(), std::size_t(1));
        const Recording::Path &path = read->paths[0];
        QCOMPARE(path.samples.size(), std::size_t(3));
        QVERIFY(length(path.samples[1].position - Point{96, 0}) < 1e-9);
        QVERIFY(length(path.samples[2].position - Point{192, 96}) < 1e-9);
        QCOMPARE(path.samples[1].pressure, 0.5f);
        QCOMPARE(path.samples[2].pressure, 1.0f);
        QCOMPARE(path.samples[0].time, 500'000);
        QCOMPARE(path.samples[2].time, 516'000);
        // 0.254 cm are 9.6 units; half of the pressure gives the pen's own width.
        QVERIFY(std::abs(path.widths[1] - 9.6) < 1e-9);
        QVERIFY(std::abs(path.widths[0] - 4.8) < 1e-9);
        QVERIFY(path.colour && std::abs(double(path.colour->opacity) - 128.0 / 255) < 1e-6);
        const std::array<double, 3> rgb = srgbFromRyb(*path.colour);
        QVERIFY(rgb[0] > 0.99 && rgb[1] < 0.01 && rgb[2] < 0.01);
        QCOMPARE(read->leftOut, QString());
    }

    void plainFilesAreRead()
    {
        const auto read = readDocument(ink("<traceFormat><channel name='X'/><channel name='Y'/></traceFormat>"
                                           "<annotation type='truth'>x</annotation>"
                                           "<trace id='0'>3 3, 20 39, 32 67, 44 98</trace>"
                                           "<traceGroup><annotation type='truth'>x</annotation>"
                                           "<traceView traceDataRef='0'/></traceGroup>"),
                                       "a.ink");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(int(read->format), int(FileFormat::InkMl));
        QCOMPARE(read->painting.strokes.size(), std::size_t(1));
        QVERIFY(read->painting.groups.empty()); // it has nothing of its own
        QCOMPARE(problemOf(read->painting), QString());
        // With the namespace's prefix, and no format at all.
        const QByteArray prefixed =
            "<inkml:ink xmlns:inkml=\"http://www.w3.org/2003/InkML\"><inkml:trace>1 1,50 50,80 9"
            "</inkml:trace></inkml:ink>";
        QCOMPARE(int(detectFormat(prefixed)), int(FileFormat::InkMl));
        QVERIFY(bool(readPainting(prefixed, "a.ink")));
    }

    void groupsAndContinuedTraces()
    {
        const auto read = readDocument(
            ink("<traceGroup><annotation type='truth'>Leaf</annotation><trace xml:id='a'>0 0,10 5,20 9</trace>"
                "<traceGroup><trace>30 0,40 5,50 9</trace></traceGroup></traceGroup>"
                "<trace xml:id='b' continuation='begin'>0 50,10 55,20 59</trace>"
                "<trace xml:id='d' continuation='end' priorRef='#b'>30 60,40 60,50 65</trace>"
                "<trace type='penUp'>0 0,9 9</trace>"),
            "a.ink");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->painting.strokes.size(), std::size_t(3));
        QCOMPARE(read->painting.groups.size(), std::size_t(2));
        QCOMPARE(read->painting.groups[0].name, QString("Leaf"));
        QCOMPARE(read->painting.groups[1].parent, read->painting.groups[0].id);
        QCOMPARE(read->painting.strokes[1]->group, read->painting.groups[1].id);
        QCOMPARE(read->painting.strokes[2]->group, GroupId(0));
        QVERIFY(read->leftOut.contains("1 way"));
    }

    void damagedFilesSayWhere()
    {
        QVERIFY2(errorOf("<trace>1 2,3</trace>").contains("line 2"), qPrintable(errorOf("<trace>1 2,3</trace>")));
        QVERIFY(errorOf("<trace>1 2,3").contains("line 2"));
        QVERIFY(errorOf("").contains("no pen strokes"));
        QVERIFY(errorOf("<trace>1 1,2e9 3</trace>").contains("1e7"));
        QByteArray deep;
        for (int k = 0; k < 100; ++k)
            deep += "<traceGroup>";
        QVERIFY(errorOf(deep).contains("too deep"));
        const QByteArray whole = ink(context() + "<traceGroup><trace contextRef='#c' brushRef='#b'>17336 2825 20735 0,"
                                                 "'-3'7 4 8,\"4\"-3 0 0,1 2 3 4</trace></traceGroup>");
        QVERIFY(bool(readPainting(whole, "a.ink")));
        QRandomGenerator random(1);
        for (int k = 0; k < 500; ++k) {
            QByteArray bytes = whole;
            for (int i = 0; i < 3; ++i)
                bytes[random.bounded(int(bytes.size()))] = char(random.bounded(256));
            const auto read = readPainting(bytes, "a.ink");
            QVERIFY(!read || problemOf(*read).isEmpty());
        }
    }
};

QTEST_GUILESS_MAIN(TestInkInkml)
#include "test_ink_inkml.moc"
