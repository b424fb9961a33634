// Going on with a stroke from its end: as wide as it is before its taper.
#include "app/session/settings/brush_library.h"
#include "model/brush/stroke_fit.h"
#include "tests/app/session.h"

#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

double spreadOf(const Segment &s)
{
    return std::sqrt(4.0 * s.diffusion * s.maxAge);
}

double widest(const std::vector<Segment> &segments)
{
    double most = 0;
    for (const Segment &s : segments)
        most = std::max(most, spreadOf(s));
    return most;
}

} // namespace

class TestExtending : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QStandardPaths::setTestModeEnabled(true);
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void fromATaperedEndItGrows_data()
    {
        QTest::addColumn<bool>("atEnd");
        QTest::newRow("the end") << true;
        QTest::newRow("the start") << false;
    }
    void fromATaperedEndItGrows()
    {
        QFETCH(bool, atEnd);
        Session s;
        Brush tapered = *findBrush("brush-pen");
        tapered.dynamics.clear();
        tapered.stabiliser = {};
        s.editor().setBrush(tapered);
        s.paintLine({300, 200}, {500, 200});
        s.dry();
        const Stroke before = *s.painting().strokes[0];
        const double body = widest(before.segments);
        const Segment &tip = atEnd ? before.segments.back() : before.segments.front();
        QVERIFY(spreadOf(tip) < 0.3 * body);
        s.editor().document().setSelection({{before.id}, {}});
        Point from{atEnd ? 500.0 : 300.0, 200}, to{atEnd ? 700.0 : 100.0, 200};
        QTest::mousePress(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at(from));
        for (int i = 1; i <= 20; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at(from + (i / 20.0) * (to - from)));
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at(to));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const Stroke after = *s.painting().strokes[0];
        QVERIFY(after.segments.size() > before.segments.size() + 5);
        const std::size_t added = after.segments.size() - before.segments.size();
        std::vector<Segment> old = after.segments, grown = after.segments;
        if (!atEnd)
            std::ranges::reverse(grown);
        grown.erase(grown.begin(), grown.begin() + std::ptrdiff_t(before.segments.size()));
        old.erase(atEnd ? old.end() - std::ptrdiff_t(added) : old.begin(),
                  atEnd ? old.end() : old.begin() + std::ptrdiff_t(added));
        QVERIFY(std::ranges::equal(old, before.segments, {}, &Segment::diffusion, &Segment::diffusion)); // its own bits
        QVERIFY2(spreadOf(grown.front()) < 0.6 * body, "it goes on where the taper ends");
        QVERIFY2(std::abs(widest(grown) / body - 1) < 0.05, "and grows to the stroke's size");
        QVERIFY(std::ranges::is_sorted(
            grown, [](const Segment &a, const Segment &b) { return spreadOf(a) < spreadOf(b) * (1 - 1e-5); }));
    }

    void withoutATaperItGoesOnAsItEnds()
    {
        Session s;
        Brush plain = *findBrush("flat-marker");
        plain.dynamics.clear();
        plain.taper = {};
        plain.stabiliser = {};
        s.editor().setBrush(plain);
        s.paintLine({300, 200}, {500, 200});
        s.dry();
        const Stroke before = *s.painting().strokes[0];
        s.editor().document().setSelection({{before.id}, {}});
        Brush other = plain;
        other.setSpread(3 * plain.spread());
        s.editor().setBrush(other);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at({500, 200}));
        for (int i = 1; i <= 20; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({500 + 10.0 * i, 200}));
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, s.at({700, 200}));
        const Stroke &after = *s.painting().strokes[0];
        QVERIFY(after.segments.size() > before.segments.size());
        QVERIFY(std::abs(spreadOf(after.segments.back()) / spreadOf(before.segments.back()) - 1) < 1e-3);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestExtending)
#include "test_extending.moc"
