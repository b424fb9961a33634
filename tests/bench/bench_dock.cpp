// How long the Strokes dock takes on the GUI thread, with a painting of many layers and strokes.
//   bench_dock [--layers 1000] [--strokes 100000] [--times 30] [--window] [--only TEXT]
// From the event until the painting is changed, the rows follow and are painted; with --window in the real window, with
// all its docks. Prints a line a case: median and 99th percentile in milliseconds, by the clock on the wall and of the
// thread's own time (which a busy machine does not spoil).
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/commands/selection_commands.h"
#include "app/window/main_window.h"
#include "render/bench/generator.h"
#include "tests/bench/bench_start.h"

#include <QAbstractProxyModel>
#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTreeView>

#include <cstdio>
#include <ctime>
#include <map>
#include <memory>

using namespace suffuse;

namespace {

/// As many strokes in each layer, one after the other; every tenth layer is in the one before it.
PaintingPtr layered(int layers, int strokes)
{
    bench::PaintingOptions options;
    options.strokes = options.segments = strokes;
    Painting painting = bench::makePainting(options);
    for (int i = 1; i <= layers; ++i) {
        Group group;
        group.id = GroupId(i);
        group.name = QStringLiteral("Layer %1").arg(i);
        group.parent = i % 10 == 0 ? GroupId(i - 1) : 0;
        painting.groups.push_back(std::move(group));
    }
    for (int k = 0; k < strokes; ++k) {
        auto stroke = std::make_shared<Stroke>(*std::as_const(painting.strokes)[std::size_t(k)]);
        stroke->group = GroupId(qint64(k) * layers / strokes + 1);
        painting.strokes[std::size_t(k)] = std::move(stroke);
    }
    return std::make_shared<const Painting>(std::move(painting));
}

/// Milliseconds that this thread has computed for.
double computed()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// The dock, alone or in the real window.
struct Stage {
    explicit Stage(bool inWindow)
    {
        if (inWindow) {
            window = std::make_unique<MainWindow>();
            window->resize(1920, 1080);
            window->show();
            panel = window->findChild<StrokesPanel *>();
        } else {
            alone = std::make_unique<Editor>();
            own = std::make_unique<StrokesPanel>(*alone);
            own->resize(320, 900);
            own->show();
            panel = own.get();
        }
        settle();
    }

    Editor &editor() { return window ? window->editor() : *alone; }
    Document &document() { return editor().document(); }
    QTreeView &view() { return *panel->view(); }

    /// Until what an event did is in the rows, and they are painted.
    void follow()
    {
        editor().laterChanges().flush();
        view().viewport()->update();
        QCoreApplication::sendPostedEvents(); // they are painted once
    }
    void settle()
    {
        for (int i = 0; i < 5; ++i)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 200);
    }
    /// The row of a layer in the view.
    QModelIndex layer(GroupId id, int column = StrokesModel::NameColumn)
    {
        return panel->viewIndexOf(middles.at(id)).parent().siblingAtColumn(column);
    }
    void click(const QModelIndex &index)
    {
        view().scrollTo(index);
        const QPointF at = view().visualRect(index).center();
        for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            QMouseEvent event(type, at, view().viewport()->mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(view().viewport(), &event);
        }
    }
    /// Rows that are taken to be dragged.
    void take(const QModelIndexList &rows)
    {
        QModelIndexList source;
        for (const QModelIndex &row : rows)
            source << sourceOf(row);
        dragged.reset(panel->model()->mimeData(source));
    }
    /// Drops them on top of what is in a group, or of all.
    void drop(GroupId into)
    {
        panel->model()->dropMimeData(dragged.get(), Qt::MoveAction, 0, 0, into ? sourceOf(layer(into)) : QModelIndex());
    }
    void drag(const QModelIndexList &rows, GroupId into)
    {
        take(rows);
        drop(into);
    }
    QModelIndex sourceOf(const QModelIndex &row)
    {
        return static_cast<QAbstractProxyModel *>(view().model())->mapToSource(row);
    }

    std::unique_ptr<Editor> alone;
    std::unique_ptr<StrokesPanel> own;
    std::unique_ptr<MainWindow> window;
    StrokesPanel *panel = nullptr;
    std::unique_ptr<QMimeData> dragged;
    std::map<GroupId, StrokeId> middles; ///< a stroke that stays in its layer
};

class Measuring {
public:
    Measuring(Stage &stage, int times, QString only) : m_stage(stage), m_times(times), m_only(std::move(only))
    {
        std::printf("%-44s %9s %9s %9s %9s\n", "milliseconds", "median", "p99", "own", "own p99");
    }

    void operator()(const char *name, const std::function<void(int)> &act, const std::function<void(int)> &before = {})
    {
        if (!QString::fromLatin1(name).contains(m_only))
            return;
        std::vector<double> wall, own;
        for (int i = 0; i < m_times; ++i) {
            if (before) {
                before(i);
                m_stage.follow();
            }
            m_stage.settle();
            QElapsedTimer timer;
            timer.start();
            const double start = computed();
            act(i);
            m_stage.follow();
            own.push_back(computed() - start);
            wall.push_back(double(timer.nsecsElapsed()) * 1e-6);
        }
        std::sort(wall.begin(), wall.end());
        std::sort(own.begin(), own.end());
        const std::size_t middle = wall.size() / 2, high = std::size_t(0.99 * double(wall.size() - 1) + 0.5);
        std::printf("%-44s %9.2f %9.2f %9.2f %9.2f\n", name, wall[middle], wall[high], own[middle], own[high]);
        std::fflush(stdout);
    }

private:
    Stage &m_stage;
    int m_times;
    QString m_only;
};

void measureRows(Stage &s, Measuring &measure, int layers)
{
    Editor &editor = s.editor();
    const auto some = [layers](int i) { return GroupId(1 + (i * 377) % layers); };
    const auto moved = [&](int i) {
        GroupId id = some(i);
        return id % 10 == 0 ? id - 1 : id;
    };
    measure("toggle the eye of a layer", [&](int i) { s.click(s.layer(some(i), StrokesModel::EyeColumn)); });
    measure(
        "undo of it", [&](int) { editor.undo(); }, [&](int i) { s.click(s.layer(some(i), StrokesModel::EyeColumn)); });
    const auto lowest = [&](int i) {
        const QModelIndex layer = s.layer(some(i + 1));
        return s.view().model()->index(s.view().model()->rowCount(layer) - 1, 0, layer);
    };
    measure("take a layer to drag it", [&](int i) { s.take({s.layer(moved(i))}); });
    measure(
        "drop a layer on top", [&](int) { s.drop(0); }, [&](int i) { s.take({s.layer(moved(i))}); });
    measure(
        "undo of it", [&](int) { editor.undo(); }, [&](int i) { s.drag({s.layer(moved(i))}, 0); });
    measure(
        "redo of it", [&](int) { editor.redo(); },
        [&](int i) {
            s.drag({s.layer(moved(i))}, 0);
            s.follow();
            editor.undo();
        });
    measure(
        "drop a stroke into another layer", [&](int i) { s.drop(some(i)); }, [&](int i) { s.take({lowest(i)}); });
    measure(
        "undo of it", [&](int) { editor.undo(); }, [&](int i) { s.drag({lowest(i)}, some(i)); });
    measure(
        "drop a layer into another one", [&](int i) { s.drop(moved(i + 1)); },
        [&](int i) { s.take({s.layer(moved(i))}); });
    measure(
        "undo of it", [&](int) { editor.undo(); }, [&](int i) { s.drag({s.layer(moved(i))}, moved(i + 1)); });
    const auto hundred = [&](int i) {
        QModelIndexList rows;
        for (int k = 0; k < std::min(100, layers / 2); ++k)
            rows << s.layer(moved(i + k));
        return rows;
    };
    measure("take 100 layers to drag them", [&](int i) { s.take(hundred(i)); });
    measure(
        "drop 100 layers on top", [&](int) { s.drop(0); }, [&](int i) { s.take(hundred(i)); });
    measure("select a layer", [&](int i) { s.click(s.layer(some(i))); });
    measure("scroll a page", [&](int) {
        QScrollBar &bar = *s.view().verticalScrollBar();
        bar.setValue(bar.value() + bar.pageStep());
    });
    measure(
        "select all", [&](int) { commands::selectAll(editor); }, [&](int) { s.document().setSelection({}); });
    measure(
        "select none", [&](int) { s.document().setSelection({}); }, [&](int) { commands::selectAll(editor); });
    measure(
        "type a letter of a search", [&](int i) { s.panel->search()->setText(QString::number(i % 10)); },
        [&](int) { s.panel->search()->clear(); });
    measure(
        "type a second letter", [&](int i) { s.panel->search()->setText(QString::number(10 + i % 10)); },
        [&](int i) { s.panel->search()->setText(QString::number((10 + i % 10) / 10)); });
    measure(
        "end a search", [&](int) { s.panel->search()->clear(); },
        [&](int i) { s.panel->search()->setText(QString::number(i % 10)); });
}

} // namespace

int main(int argc, char *argv[])
{
    const QTemporaryDir folder;
    useOwnSettings(folder);
    QApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"layers", "Layers (1000).", "count", "1000"},
                       {"strokes", "Strokes in them (100000).", "count", "100000"},
                       {"times", "How often each is done (30).", "count", "30"},
                       {"window", "In the real window."},
                       {"only", "Only what has this in its name.", "text"}});
    parser.process(application);
    const int layers = std::max(parser.value("layers").toInt(), 20);
    const PaintingPtr painting = layered(layers, std::max(parser.value("strokes").toInt(), 2 * layers));
    Stage stage(parser.isSet("window"));
    for (const StrokePtr &stroke : painting->strokes)
        stage.middles[stroke->group] = stroke->id;
    Measuring measure(stage, std::max(parser.value("times").toInt(), 1), parser.value("only"));
    measure(
        "open", [&](int) { stage.document().reset(painting); },
        [&](int) { stage.document().reset(std::make_shared<const Painting>()); });
    if (stage.document().painting()->strokes.empty())
        stage.document().reset(painting);
    stage.editor().clock().setTime(painting->end());
    measureRows(stage, measure, layers);
    const auto openAll = [&] {
        for (int i = 1; i <= layers; ++i)
            stage.view().expand(stage.layer(GroupId(i)));
    };
    measure(
        "open all layers", [&](int) { openAll(); }, [&](int) { stage.view().collapseAll(); });
    std::printf("with all layers open\n");
    openAll();
    measureRows(stage, measure, layers);
    return 0;
}
