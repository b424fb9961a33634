// Small files that were made to harm: each reader says what is wrong, or reads what there is, in bounded memory. The
// files lie in tests/hostile; larger ones are made here.
#include "model/formats/brushes/brush_file.h"
#include "model/formats/brushes/gimp_palette.h"
#include "model/formats/brushes/mypaint_brush.h"
#include "model/formats/files.h"
#include "model/formats/svg/paths/svg_paths.h"
#include "model/painting/validate.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTest>

#include <malloc.h>
#include <sys/resource.h>

using namespace suffuse;

namespace {

/// Reads with whatever a window would read such a file with; an error is not empty, a painting is valid.
void readAsAnything(const QByteArray &bytes, const QString &name)
{
    if (const Result<LoadedDocument> document = readDocument(bytes, name))
        QCOMPARE(problemOf(document->painting), QString());
    else
        QVERIFY(document.error().startsWith(name + QLatin1Char(':')));
    if (const Result<std::vector<SvgPath>> paths = readSvgPaths(bytes); !paths)
        QVERIFY(!paths.error().isEmpty());
    if (const Result<Brush> brush = readBrush(bytes, name); !brush)
        QVERIFY(brush.error().contains(name));
    if (const Result<LoadedBrush> brush = readMyPaintBrush(bytes, name); !brush)
        QVERIFY(brush.error().contains(name));
    if (const Result<GimpPalette> palette = readGimpPalette(bytes, name); !palette)
        QVERIFY(palette.error().contains(name));
}

/// Sanitizers look at every step: there, what is made here is a hundredth as large. They also keep what is freed, so
/// that memory is measured without them alone.
#ifdef SUFFUSE_SANITIZED
constexpr int shrink = 100;
constexpr qint64 mostMemory = std::numeric_limits<qint64>::max();
#else
constexpr int shrink = 1;
constexpr qint64 mostMemory = qint64(512) << 20;
#endif

/// Greatest memory of this process so far, bytes.
qint64 peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return qint64(usage.ru_maxrss) * 1024;
}

QByteArray repeated(const QByteArray &part, int times)
{
    QByteArray all;
    all.reserve(part.size() * times);
    for (int i = 0; i < times; ++i)
        all += part;
    return all;
}

/// Path data of lines (L) or curves (C) through a square, each of which crosses most others.
QByteArray scribble(const char *command, int count)
{
    QByteArray data;
    unsigned number = 1;
    for (int i = 0; i < (*command == 'C' ? 3 : 1) * count; ++i) {
        data += i == 0 ? command : " ";
        for (int k = 0; k < 2; ++k) {
            number = number * 1664525u + 1013904223u;
            data += QByteArray::number(number >> 22) + ' ';
        }
    }
    return data;
}

} // namespace

class TestHostileFiles : public QObject {
    Q_OBJECT

private slots:
    void files_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/hostile"));
        QStringList names;
        for (QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories); files.hasNext();)
            names << folder.relativeFilePath(files.next());
        names.sort();
        QVERIFY(names.size() >= 40);
        for (const QString &name : names)
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    void files()
    {
        QFETCH(const QString, path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        readAsAnything(file.readAll(), QStringLiteral("a.file"));
    }

    /// What is too large to keep: depth, width, and long tokens. None may cost more than a small multiple of its size.
    void made_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const int many = 1'000'000 / shrink;
        QTest::newRow("deep JSON lists") << repeated("[", many);
        QTest::newRow("deep JSON objects") << repeated("{\"a\":", many);
        QTest::newRow("deep inside a painting")
            << QByteArray("{\"format\": \"suffuse-text\", \"version\": 1, \"canvas\": ") + repeated("[", many);
        QTest::newRow("deep groups of an Excalidraw drawing")
            << QByteArray("{\"type\": \"excalidraw\", \"elements\": ") + repeated("[[", many / 2);
        QTest::newRow("deep SVG") << QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\">") + repeated("<g>", many);
        QTest::newRow("deep XML") << QByteArray("<curve_set image_width=\"9\" image_height=\"9\">") +
                                         repeated("<curve>", many);
        QTest::newRow("SVG that uses itself doubling") << [] {
            QByteArray text("<svg xmlns=\"http://www.w3.org/2000/svg\"><defs><path id=\"a0\" d=\"M0 0h1\"/>");
            for (int i = 1; i <= 60; ++i)
                text += "<g id=\"a" + QByteArray::number(i) + "\"><use href=\"#a" + QByteArray::number(i - 1) +
                        "\"/><use href=\"#a" + QByteArray::number(i - 1) + "\"/></g>";
            return text + "</defs><use href=\"#a60\"/></svg>";
        }();
        QTest::newRow("a billion laughs") << [] {
            QByteArray text("<?xml version=\"1.0\"?><!DOCTYPE svg [<!ENTITY a0 \"ha\">");
            for (int i = 1; i <= 40; ++i)
                text += "<!ENTITY a" + QByteArray::number(i) + " \"" +
                        repeated("&a" + QByteArray::number(i - 1) + ";", 10) + "\">";
            return text + "]><svg xmlns=\"http://www.w3.org/2000/svg\"><title>&a40;</title></svg>";
        }();
        QTest::newRow("one long line of ink") << QByteArray("x,y\n") + repeated("1,", many);
        QTest::newRow("one long number") << QByteArray("x,y\n1,") + repeated("9", many);
        QTest::newRow("path data without end")
            << QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0") + repeated("l1 1", many) +
                   "\"/></svg>";
        QTest::newRow("many long paths") << QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\">") +
                                                repeated("<path d=\"M0 0" + repeated("h1", 2 * many) + "\"/>", 4) +
                                                "</svg>";
        // Outlines of pens: lines that cross themselves, more dashes than can be seen, and pens as wide as the world.
        const QByteArray pens = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000' fill='none' "
                                "stroke='red' stroke-width='20'>";
        QTest::newRow("a line that crosses itself everywhere")
            << pens + "<path d='M0 0" + scribble("L", 100'000 / shrink) + "z'/></svg>";
        QTest::newRow("curves that cross themselves everywhere")
            << pens + "<path stroke-width='1' d='M0 0" + scribble("C", 30'000 / shrink) + "'/></svg>";
        QTest::newRow("thousands of scribbles") << [&] {
            QByteArray text = pens;
            for (int i = 0; i < 3000 / shrink; ++i)
                text += "<path d='M0 0" + scribble("L", 50) + "'/>";
            return text + "</svg>";
        }();
        QTest::newRow("countless dashes") << pens +
                                                 repeated("<path stroke-dasharray='0 .02' stroke-linecap='round' "
                                                          "d='M0 0h1000'/><path stroke-dasharray='.011' "
                                                          "d='M0 0h1000'/>",
                                                          1000 / shrink) +
                                                 "</svg>";
        QTest::newRow("pens as wide as the world")
            << pens + "<g stroke-width='1e7'><path d='M0 0" + scribble("C", 20'000 / shrink) + "'/></g></svg>";
        QTest::newRow("a grid of lines") << [&] {
            QByteArray text = pens + "<path stroke-width='.3' d='";
            for (int i = 0; i < 1000 / shrink; ++i)
                text += "M" + QByteArray::number(i) + " 0v1000M0 " + QByteArray::number(i) + "h1000";
            return text + "'/></svg>";
        }();
        // Clip paths: one as intricate as can be, one for each of many shapes, and clips of clips.
        QTest::newRow("an intricate clip path")
            << pens + "<clipPath id='c'><path clip-rule='evenodd' d='M0 0" + scribble("L", 100'000 / shrink) +
                   "z'/></clipPath><g stroke='none' fill='red' clip-path='url(#c)'>" +
                   repeated("<rect width='999' height='999'/>", 1000 / shrink) + "</g></svg>";
        QTest::newRow("clips of clips of intricate areas") << [&] {
            QByteArray text = pens;
            for (int i = 0; i < 200; ++i)
                text += "<clipPath id='c" + QByteArray::number(i) + "' clip-path='url(#c" + QByteArray::number(i + 1) +
                        ")'><path d='M0 0" + scribble("L", 300) + "z'/></clipPath><g clip-path='url(#c" +
                        QByteArray::number(i) + ")'>";
            return text + "<g fill='red'>" + repeated("<path d='M0 0" + scribble("C", 100) + "'/>", 500 / shrink) +
                   "</g>" + repeated("</g>", 200) + "</svg>";
        }();
        QTest::newRow("thousands of nested drawings")
            << pens + repeated("<svg viewBox='1 1 998 998'>", 200) +
                   repeated("<path fill='red' d='M0 0" + scribble("C", 50) + "'/>", 2000 / shrink) +
                   repeated("</svg>", 200) + "</svg>";
        // Gradients of many rings in many intricate shapes, and opacities of everything over everything.
        const QByteArray server = "<radialGradient id='g' spreadMethod='reflect' r='0.01'><stop stop-color='red'/>"
                                  "<stop offset='1' stop-color='blue' stop-opacity='.5'/></radialGradient>";
        QTest::newRow("rings without end")
            << pens + server + repeated("<path fill='url(#g)' d='M0 0" + scribble("C", 100) + "'/>", 2000 / shrink) +
                   "</svg>";
        QTest::newRow("opacities of scribbles") << [&] {
            QByteArray text = pens + repeated("<g opacity='.9'>", 100);
            text += repeated("<path fill='red' fill-opacity='.5' d='M0 0" + scribble("L", 20) + "'/>", 2000 / shrink);
            return text + repeated("</g>", 100) + "</svg>";
        }();
        QTest::newRow("markers in markers at a million nodes")
            << pens + "<marker id='m'><path marker='url(#m)' stroke='red' d='M0 0" + repeated("h1v1", 100) +
                   "'/></marker>" +
                   repeated("<path marker='url(#m)' d='M0 0" + repeated("h1v1", 100'000 / shrink) + "'/>", 5) +
                   "</svg>";
        QTest::newRow("a palette of one line") << QByteArray("GIMP Palette\n") + repeated("1 2 3 ", many);
        QTest::newRow("only the signature") << QByteArray("\x89SUFFUSE\r\n\x1a\n", 12);
        QTest::newRow("zeros") << QByteArray(4 * many, '\0');
    }
    void made()
    {
        QFETCH(const QByteArray, bytes);
        malloc_trim(0); // What the files before have left in the heap is not this one's.
        readAsAnything(bytes, QStringLiteral("a.file"));
        QVERIFY2(peakMemory() < mostMemory, qPrintable(QString::number(peakMemory() >> 20) + " MiB"));
    }
};

QTEST_GUILESS_MAIN(TestHostileFiles)
#include "test_hostile_files.moc"
