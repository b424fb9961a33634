// Hours of painting, the same round again and again: paint, edit, undo, zoom, let it dry, start anew. Memory in use
// after a round stays what it was. SUFFUSE_SOAK_SECONDS says for how long (30; hours by hand, see docs/reliability.md).
#include "tests/app/session.h"

#include <QElapsedTimer>
#include <QPixmapCache>
#include <QTemporaryDir>
#include <QWheelEvent>

#include <algorithm>
#include <malloc.h>

using namespace suffuse;

namespace {

constexpr double mib = 1 << 20;
constexpr double hour =
    240; ///< rounds of a painter at work: 2,880 strokes; the script does a round in a tenth of a second

/// Bytes that were asked for and not given back: what a leak makes grow, whatever the allocator keeps.
double bytesInUse()
{
    QPixmapCache::clear(); // Qt's, which fills up to 10 MiB
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
}

void wheel(QWidget &widget, QPointF at, int delta)
{
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&widget, &event);
}

/// One round of work; ends with the document that it began with and an empty history.
void workARound(Session &s)
{
    Editor &editor = s.editor();
    editor.document().reset(std::make_shared<const Painting>());
    editor.undoStack().clear();
    editor.clock().setTime(0);
    s.use(Command::Brush);
    for (int i = 0; i < 12; ++i)
        s.paintLine({60.0 + 40 * i, 80}, {300.0 + 20 * i, 600.0 - 30 * i});
    s.dry();
    s.use(Command::SelectAll);
    s.use(Command::Duplicate);
    s.use(Command::Undo);
    s.use(Command::Select);
    s.click({180, 340});
    s.use(Command::Raise);
    s.use(Command::Delete);
    s.use(Command::Segments);
    s.click({300, 300});
    for (int delta : {120, 120, -120, -120, -120, 120})
        wheel(s.canvas(), QPointF(400, 300), delta);
    editor.clock().setTime(500'000);
    s.dry();
    while (editor.undoStack().canUndo())
        s.use(Command::Undo);
    QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs);
}

} // namespace

class TestSoak : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void memoryStaysWhatItWas()
    {
        const int asked = qEnvironmentVariableIntValue("SUFFUSE_SOAK_SECONDS");
        const qint64 wanted = (asked > 0 ? asked : 30) * qint64(1000);
        Session s;
        for (int i = 0; i < 60; ++i)
            workARound(s); // caches fill
        QElapsedTimer clock;
        clock.start();
        std::vector<double> inUse;
        do {
            workARound(s);
            if (QTest::currentTestFailed())
                return;
            inUse.push_back(bytesInUse());
            if (qEnvironmentVariableIsSet("SUFFUSE_SOAK_TRACE") && inUse.size() % 50 == 0)
                qInfo("%zu rounds: %.3f MiB", inUse.size(), inUse.back() / mib);
        } while (clock.elapsed() < wanted || inUse.size() < 8);
        // The least of each quarter: what caches hold in passing does not count. A leak grows from each to the next, a
        // cache that fills late grows once, so the least growth counts.
        const std::size_t quarter = inUse.size() / 4;
        std::vector<double> least;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto from = inUse.begin() + std::ptrdiff_t(k * quarter);
            least.push_back(*std::min_element(from, from + std::ptrdiff_t(quarter)));
        }
        const double more = std::min({least[1] - least[0], least[2] - least[1], least[3] - least[2]});
        const double growth = more / double(quarter) * hour;
        qInfo("%zu rounds in %.1f s: %.2f MiB in use, %.3f, %.3f and %.3f MiB more from quarter to quarter, %.3f MiB in an "
              "hour of painting",
              inUse.size(), double(clock.elapsed()) / 1000, least[0] / mib, (least[1] - least[0]) / mib,
              (least[2] - least[1]) / mib, (least[3] - least[2]) / mib, growth / mib);
        QVERIFY(growth < mib || more < 0.25 * mib); // few rounds tell little
    }

private:
    QTemporaryDir m_folder;
};

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    TestSoak test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_soak.moc"
