// A recorded painting, played to the canvas as a pen's reports: it becomes what its import is, bit for bit.
// SUFFUSE_RECORDING names a file of MyPaint events (time, x, y, pressure); without it one is made up.
#include "app/session/editor.h"
#include "model/formats/files.h"
#include "model/shaping/transform.h"
#include "tests/app/pen_hand.h"
#include "tests/app/session.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <random>

using namespace suffuse;

namespace {

struct Row {
    Microseconds time = 0;
    Point at;
    double pressure = 0;
};

/// A tablet's grid: on it, positions are exact in any frame of reference.
double onGrid(double x)
{
    return std::round(x * 256) / 256;
}

std::vector<Row> rowsOf(const QByteArray &bytes)
{
    std::vector<Row> rows;
    for (const QByteArray &line : bytes.split('\n')) {
        const QList<QByteArray> cells = line.simplified().split(' ');
        if (cells.size() == 4)
            rows.push_back({Microseconds(std::llround(cells[0].toDouble() * 1e6)),
                            {onGrid(cells[1].toDouble()), onGrid(cells[2].toDouble())},
                            cells[3].toDouble()});
    }
    return rows;
}

QByteArray bytesOf(const std::vector<Row> &rows)
{
    QByteArray bytes;
    for (const Row &r : rows)
        bytes += QByteArray::number(double(r.time) * 1e-6, 'e', 18) + ' ' + QByteArray::number(r.at.x, 'e', 18) + ' ' +
                 QByteArray::number(r.at.y, 'e', 18) + ' ' + QByteArray::number(r.pressure, 'e', 18) + '\n';
    return bytes;
}

/// As pens are: reports at 8 ms, now and then one too few, the same place twice, the same time twice, hovering between
/// the strokes for a while or for long, a tap, a stroke of two reports, the last one never lifted.
std::vector<Row> madeUpRows()
{
    std::mt19937 random(5);
    const auto dice = [&random](int sides) { return int(random() % unsigned(sides)); };
    std::vector<Row> rows;
    Microseconds time = 0;
    const auto report = [&](Point at, double pressure) {
        rows.push_back({time, {onGrid(at.x), onGrid(at.y)}, pressure});
        time += dice(20) == 0 ? 0 : dice(4) == 0 ? 16'000 : dice(9) == 0 ? 9'000 : 8'000;
    };
    const int lengths[] = {40, 1, 75, 2, 120, 9, 60, 33};
    for (int k = 0; k < int(std::size(lengths)); ++k) {
        const Point start{60.0 + 90 * k, 250 + 40.0 * dice(5)};
        for (int i = 0; i < 6; ++i)
            report(start - Point{6.0 - i, 3}, 0);
        for (int i = 0; i < lengths[k]; ++i) {
            const double way = double(i) / lengths[k];
            const Point at = start + Point{70 * way + 4 * std::sin(9 * way), 60 * std::sin(5 * way + k)};
            report(dice(12) == 0 && rows.back().pressure > 0 ? rows.back().at : at,
                   0.02 + 0.5 * std::sin(3 * way + 0.1));
        }
        report(rows.back().at, k + 1 < int(std::size(lengths)) ? 0 : 0.1);
        time += k == 2 ? 4'000'000 : k == 4 ? 700'000 : 0;
    }
    return rows;
}

std::vector<Row> recording()
{
    const QString path = qEnvironmentVariable("SUFFUSE_RECORDING");
    if (path.isEmpty())
        return madeUpRows();
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? rowsOf(file.readAll()) : std::vector<Row>();
}

/// The default brush without what only a hand on a screen needs, its size a power of two so that the import moves all
/// by a number that is on the grid.
Brush brush()
{
    Brush brush = builtinBrushes().front();
    brush.stabiliser = {};
    brush.diffusion = 8;
    brush.maxAge = 2;
    return brush;
}

/// A window on a canvas whose units are its pixels.
struct Replay : Session {
    explicit Replay(const Canvas &size)
    {
        [&] { QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs); }(); // it has its size
        editor().newPainting(size);
        editor().setBrush(brush());
        use(Command::Brush);
        View view = canvas().view();
        view.scale = 1;
        view.centre = {0.5 * view.width, 0.5 * view.height};
        canvas().lookThrough(view);
        editor().clock().setTime(0);
    }
    void send(const Row &row, quint64 stamp = 0)
    {
        const bool touches = row.pressure > 0;
        if (!touches && !m_down)
            return; // hovering
        const QEvent::Type type = !touches ? QEvent::TabletRelease : m_down ? QEvent::TabletMove : QEvent::TabletPress;
        m_down = touches;
        pen.send(canvas(), {type, row.at, row.pressure, 0, 0, stamp});
    }
    void lift(Point at, quint64 stamp = 0)
    {
        if (std::exchange(m_down, false))
            pen.send(canvas(), {QEvent::TabletRelease, at, 0, 0, 0, stamp});
    }

    PenHand pen;

private:
    bool m_down = false;
};

/// With the clock of its import: the first touch is at time 0, the first sample 2 spreads from the edges.
std::vector<Row> movedLike(std::vector<Row> rows)
{
    Rect box;
    Microseconds start = std::numeric_limits<Microseconds>::max();
    for (const Row &r : rows)
        if (r.pressure > 0) {
            box.include(r.at);
            start = std::min(start, r.time);
        }
    const double margin = 2 * brush().spread();
    for (Row &r : rows) {
        r.at = r.at + Point{margin - box.left, margin - box.top};
        r.time -= start;
    }
    return rows;
}

/// The same segments at the same moments from the start on. What lies between samples is weighted by moments, which
/// round differently where a stroke begins at another one: a few units in the last place of a float.
bool isSamePace(const Stroke &a, const Stroke &b)
{
    constexpr double ulps = 8 * 0x1p-23;
    const auto near = [](double x, double y, double size) { return std::abs(x - y) <= ulps * size; };
    const double reach = std::hypot(curveBox(a).width(), curveBox(a).height());
    return std::ranges::equal(a.segments, b.segments, [&](const Segment &s, const Segment &t) {
        bool same = s.born - a.born() == t.born - b.born() && near(s.density, t.density, s.density) &&
                    near(s.diffusion, t.diffusion, s.diffusion) && near(s.granulation, t.granulation, 1) &&
                    near(s.maxAge, t.maxAge, s.maxAge);
        for (std::size_t i = 0; i < 4; ++i)
            same = same && near(s.bezier[i].x, t.bezier[i].x, reach) && near(s.bezier[i].y, t.bezier[i].y, reach);
        return same;
    });
}

} // namespace

class TestRecorded : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        m_rows = recording();
        QVERIFY(m_rows.size() > 100);
        const Brush b = brush();
        Result<Painting> imported = readPainting(bytesOf(m_rows), "recording.dat", &b);
        QVERIFY2(imported, qPrintable(imported.error()));
        m_imported = *imported;
        QVERIFY(m_imported.strokes.size() > 5);
        m_rows = movedLike(m_rows);
    }

    /// Every report at its recorded moment: the same strokes, each number of them.
    void aReplayIsTheImport()
    {
        Replay replay(m_imported.canvas);
        for (const Row &row : m_rows) {
            QCOMPARE(replay.canvas().view().toCanvas(row.at), row.at);
            replay.editor().clock().setTime(std::max<Microseconds>(row.time, 0));
            replay.send(row);
        }
        replay.lift(m_rows.back().at);
        QCOMPARE(replay.painting().strokes.size(), m_imported.strokes.size());
        std::size_t segments = 0;
        for (std::size_t i = 0; i < m_imported.strokes.size(); ++i) {
            const Stroke &live = *replay.painting().strokes[i], &imported = *m_imported.strokes[i];
            QCOMPARE(live.segments.size(), imported.segments.size());
            QCOMPARE(live.born(), imported.born());
            QVERIFY2(live == imported, qPrintable(QStringLiteral("stroke %1").arg(i)));
            segments += live.segments.size();
        }
        QCOMPARE(replay.editor().undoStack().count(), int(m_imported.strokes.size()));
        qInfo("%zu reports: %zu strokes of %zu segments, bit for bit", m_rows.size(), m_imported.strokes.size(),
              segments);
    }

    /// With the clock on the wall, and reports that arrive a little late and in bunches: the pen's own stamps keep the
    /// pace, so that only the moment at which a stroke begins is the hand's.
    void stampsKeepThePace()
    {
        Replay replay(m_imported.canvas);
        replay.editor().clock().setManual(false);
        int compared = 0;
        for (std::size_t from = 0, stroke = 0; from < m_rows.size() && compared < 3;) {
            const auto touches = [](const Row &r) { return r.pressure > 0; };
            const auto first = std::find_if(m_rows.begin() + std::ptrdiff_t(from), m_rows.end(), touches);
            const auto last = std::find_if_not(first, m_rows.end(), touches);
            if (first == m_rows.end())
                break;
            from = std::size_t(last - m_rows.begin());
            const Stroke &imported = *m_imported.strokes[stroke++];
            if (imported.segments.size() < 8 || (last - 1)->time - first->time > 1'000'000)
                continue;
            for (int tries = 0; !played(replay, {first, last}); ++tries)
                QVERIFY2(tries < 20, "this machine never had a moment's rest");
            QCOMPARE(replay.canvas().view().toCanvas(first->at), first->at);
            const Stroke &live = *replay.painting().strokes[replay.painting().strokes.size() - 1];
            QVERIFY(isSamePace(live, imported));
            ++compared;
        }
        QCOMPARE(compared, 3);
    }

private:
    /// A stroke in real time. False where the machine paused for so long that stamps are not believed.
    static bool played(Replay &replay, const std::vector<Row> &rows)
    {
        constexpr Microseconds believed = 200'000; // of 250
        QElapsedTimer clock;
        clock.start();
        Microseconds latest = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Microseconds due = rows[i].time - rows[0].time;
            if (i % 3 == 0) // the others come together with it
                while (clock.nsecsElapsed() / 1000 < due)
                    QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
            latest = std::max<Microseconds>(latest, std::abs(clock.nsecsElapsed() / 1000 - due));
            replay.send(rows[i], 1000 + quint64(due / 1000));
        }
        replay.lift(rows.back().at, 1000 + quint64((rows.back().time - rows[0].time) / 1000));
        return latest < believed;
    }

    QTemporaryDir m_folder;
    std::vector<Row> m_rows;
    Painting m_imported;
};

QTEST_MAIN(TestRecorded)
#include "test_recorded.moc"
