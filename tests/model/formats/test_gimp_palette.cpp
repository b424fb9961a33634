// GIMP palettes in and out.
#include "model/formats/brushes/gimp_palette.h"
#include "model/painting/ryb.h"

#include <QtTest>

using namespace suffuse;

namespace {

GimpPalette read(const QByteArray &bytes)
{
    const auto palette = readGimpPalette(bytes, "a.gpl");
    if (!palette)
        qFatal("%s", qPrintable(palette.error()));
    return *palette;
}

} // namespace

class TestGimpPalette : public QObject {
    Q_OBJECT

private slots:
    void readsWhatGimpWrites()
    {
        const GimpPalette palette = read("GIMP Palette\nName: Bears\nColumns: 4\n#\n"
                                         "  8   8   8\tgrey3\n255   0   0\tUntitled\n# a note\n\n0 0 255 deep  blue\n");
        QCOMPARE(palette.name, QString("Bears"));
        QCOMPARE(palette.swatches.size(), std::size_t(3));
        QCOMPARE(palette.swatches[0].name, QString("grey3"));
        QCOMPARE(palette.swatches[1], (Swatch{{}, rybFromSrgb(1, 0, 0)}));
        QCOMPARE(palette.swatches[2], (Swatch{"deep  blue", rybFromSrgb(0, 0, 1)}));
    }

    void takesOtherLineEndsAndEncodings()
    {
        QCOMPARE(read("GIMP Palette\r\nName: a\r\n1 2 3\r\n").swatches,
                 read("GIMP Palette\nName: a\n1\t2\t3").swatches);
        QCOMPARE(read("GIMP Palette\n1 2 3 gr\xc3\xbcn").swatches[0].name, QString::fromUtf8("grün"));
        QCOMPARE(read("GIMP Palette\n1 2 3 gr\xfcn").swatches[0].name, QString::fromUtf8("grün"));
        QCOMPARE(read("GIMP Palette").swatches.size(), std::size_t(0));
    }

    void roundTrips()
    {
        GimpPalette palette{"mine", {}};
        for (int i = 0; i < 256; i += 5)
            palette.swatches.push_back({i % 2 ? QString() : QString("c %1").arg(i),
                                        rybFromSrgb(i / 255.0, (255 - i) / 255.0, (i * 7 % 256) / 255.0)});
        const GimpPalette again = read(writeGimpPalette(palette));
        QCOMPARE(again.name, palette.name);
        QCOMPARE(again.swatches, palette.swatches);
        // A name cannot break the form.
        const GimpPalette odd = read(writeGimpPalette({"a\nb", {{"x\n0 0 0", Colour{}}}}));
        QCOMPARE(odd.name, QString("a b"));
        QCOMPARE(odd.swatches.size(), std::size_t(1));
        QCOMPARE(odd.swatches[0].name, QString("x 0 0 0"));
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &bytes, const char *message) {
            QTest::addRow("%s", name) << bytes << QString(message);
        };
        row("nothing", "", "a.gpl: line 1: “GIMP Palette” is missing");
        row("other", "RIFF....PAL ", "a.gpl: line 1: “GIMP Palette” is missing");
        row("word", "GIMP Palette\nName: a\n#\n1 2 red\n", "a.gpl: line 4: “red” is not a number from 0 to 255");
        row("range", "GIMP Palette\n1 2 256\n", "a.gpl: line 2: “256” is not a number from 0 to 255");
        row("negative", "GIMP Palette\n-1 2 3\n", "a.gpl: line 2: “-1” is not a number from 0 to 255");
        row("short", "GIMP Palette\n\n1 2\n", "a.gpl: line 3: a colour has three numbers");
        row("many", "GIMP Palette\n" + QByteArray("0 0 0\n").repeated(10'001),
            "a.gpl: line 10002: there are more than");
        row("large", "GIMP Palette\n" + QByteArray(1 << 20, '#'), "a.gpl: is larger than 1 MiB");
    }

    void refuses()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, message);
        const auto palette = readGimpPalette(bytes, "a.gpl");
        QVERIFY(!palette);
        QVERIFY2(palette.error().startsWith(message), qPrintable(palette.error()));
    }

    void anyBytesAreReadOrRefused()
    {
        QRandomGenerator random(5);
        const QByteArray good = "GIMP Palette\nName: a\nColumns: 3\n#\n1 2 3 one\n4 5 6\ttwo\n";
        for (int i = 0; i < 5000; ++i) {
            QByteArray bytes = good;
            for (int k = random.bounded(4); k >= 0; --k)
                bytes[random.bounded(bytes.size())] = char(random.bounded(256));
            const auto palette = readGimpPalette(bytes, "a.gpl");
            QVERIFY(palette ? palette->swatches.size() <= 4 : palette.error().startsWith("a.gpl: line "));
        }
    }
};

QTEST_GUILESS_MAIN(TestGimpPalette)
#include "test_gimp_palette.moc"
