// The papers that the program offers, and what files keep of them.
#include "model/formats/files.h"
#include "model/painting/paper_presets.h"
#include "model/painting/validate.h"

#include <QtTest>

#include <set>

using namespace suffuse;

class TestPaper : public QObject {
    Q_OBJECT

private slots:
    void presetsAreNumbers()
    {
        std::set<QString> names;
        std::set<PaperGrain> grains;
        int index = 0;
        for (const PaperPreset &preset : paperPresets()) {
            Canvas canvas;
            canvas.paper = paperOf(preset, 77);
            QCOMPARE(problemOf(canvas), QString());
            QCOMPARE(canvas.paper.seed, 77u);
            QCOMPARE(presetOf(canvas.paper), index++);
            names.insert(titleOf(preset));
            grains.insert(preset.grain);
        }
        QCOMPARE(names.size(), paperPresets().size());
        QCOMPARE(names.size(), std::size_t(5));
        QCOMPARE(grains.size(), std::size_t(3));
        QCOMPARE(presetOf(Paper{}), -1);
        Paper changed = paperOf(paperPresets()[1]);
        changed.scale *= 1.5f;
        QCOMPARE(presetOf(changed), -1);
    }

    void filesKeepTheGrain_data()
    {
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(paperPresets().size()); ++i)
            QTest::addRow("%s", paperPresets()[std::size_t(i)].name) << i;
    }

    void filesKeepTheGrain()
    {
        QFETCH(int, index);
        Painting painting;
        painting.canvas.paper = paperOf(paperPresets()[std::size_t(index)], 5);
        const auto text = readPainting(writeTextForm(painting), "a.json");
        QVERIFY2(text, qPrintable(text.error()));
        QVERIFY(*text == painting);
        const auto bytes = readPainting(writeSuffuseFile(painting), "a.suffuse");
        QVERIFY2(bytes, qPrintable(bytes.error()));
        QVERIFY(*bytes == painting);
    }

    void filesFromBeforeHaveTooth()
    {
        const auto text = readPainting(R"({"format": "suffuse-text", "version": 1, "strokes": [],
            "canvas": {"paper": {"kind": "procedural", "seed": 3, "scale": 9}}})",
                                       "a.json");
        QVERIFY2(text, qPrintable(text.error()));
        QCOMPARE(text->canvas.paper.grain, PaperGrain::Tooth);
        QCOMPARE(text->canvas.paper.seed, 3u);
        // What is written of tooth is what was written before.
        QVERIFY(!writeTextForm(*text).contains("grain"));
    }
};

QTEST_GUILESS_MAIN(TestPaper)
#include "test_paper.moc"
