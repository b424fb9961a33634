#include "app/tools/shapes/bucket_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QHBoxLayout>

namespace suffuse {

namespace {

constexpr double mostUnits = 1000;

double storedNumber(const char *name, double usual, double least, double greatest)
{
    bool ok = false;
    const double value = settings::store().value(QLatin1String(name), usual).toDouble(&ok);
    return ok && value >= least && value <= greatest ? value : usual;
}

} // namespace

BucketTool::BucketTool(CanvasWidget &canvas, QObject *parent) : CanvasTool(canvas, parent)
{
    m_wish.tolerance = storedNumber("tools/bucket/tolerance", m_wish.tolerance, 0, 1);
    m_wish.gap = storedNumber("tools/bucket/gap", m_wish.gap, 0, mostUnits);
    m_wish.grow = storedNumber("tools/bucket/grow", m_wish.grow, -mostUnits, mostUnits);
    m_isUnder = settings::store().value("tools/bucket/under", false).toBool();
    connect(&m_job, &BucketJob::done, this, &BucketTool::take);
}

QString BucketTool::hint() const
{
    if (m_job.isRunning())
        return tr("Looking for what the paint bounds there. Esc gives it up.");
    return said().isEmpty() ? tr("Click: fill what the paint around that place bounds, with the brush in hand.")
                            : said();
}

QWidget *BucketTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    auto *places = new QComboBox(m_options);
    places->setObjectName("place");
    places->addItems({tr("Over all strokes"), tr("Under all strokes")});
    places->setToolTip(tr("Where the fill lies"));
    places->setAccessibleName(tr("Where the fill lies"));
    connect(places, &QComboBox::activated, this, [this](int index) { setWish(m_wish, index == 1); });
    row->addWidget(places);
    row->addSpacing(10);
    const auto add = [&](const FieldSpec &spec, double RegionWish::*member) {
        NumberField *field = addNumber(*row, spec, [this, member](double value) {
            RegionWish wish = m_wish;
            wish.*member = value;
            setWish(wish, m_isUnder);
        });
        field->setValue(m_wish.*member);
    };
    add(shareSpec(tr("Tolerance"), tr("By how much colours may differ from that under the pointer"), 0.1),
        &RegionWish::tolerance);
    add({tr("Gap"), tr("Openings of the bounds that are narrower are closed"), lengthDisplay(), 0, mostUnits},
        &RegionWish::gap);
    add({tr("Grow by"), tr("How far the fill reaches under its bounds"), lengthDisplay(), -mostUnits, mostUnits},
        &RegionWish::grow);
    row->addStretch();
    places->setCurrentIndex(m_isUnder);
    return m_options;
}

void BucketTool::setWish(const RegionWish &wish, bool isUnder)
{
    m_wish = wish;
    m_isUnder = isUnder;
    QSettings &store = settings::store();
    store.setValue("tools/bucket/tolerance", wish.tolerance);
    store.setValue("tools/bucket/gap", wish.gap);
    store.setValue("tools/bucket/grow", wish.grow);
    store.setValue("tools/bucket/under", isUnder);
    if (m_options)
        m_options->findChild<QComboBox *>("place")->setCurrentIndex(isUnder);
}

void BucketTool::press(const PointerEvent &event)
{
    say({});
    m_isPressed = !event.doubleClick && m_editor.layer().takesPaint(); // Its first click has filled what is there.
}

void BucketTool::release(const PointerEvent &event)
{
    if (!std::exchange(m_isPressed, false))
        return;
    m_waiting.push_back(
        {nullptr, nullptr, event.time, event.point, m_wish, m_canvas.view().scale, m_isUnder, m_editor.brush(), 0});
    if (!m_job.isRunning())
        startNext();
}

void BucketTool::startNext()
{
    if (!m_waiting.empty()) {
        BucketOrder order = std::move(m_waiting.front());
        m_waiting.pop_front();
        order.painting = m_editor.document().painting();
        order.bounds = m_editor.layer().reached();
        order.id = m_editor.document().takeStrokeId();
        m_job.start(order);
    }
    emit hintChanged();
    emit asideChanged();
}

void BucketTool::take(const BucketOrder &order, const StrokePtr &stroke)
{
    const Document &document = m_editor.document();
    if (document.painting() != order.painting) {
        say(tr("The painting has changed meanwhile: nothing was filled."));
    } else if (stroke) {
        Edit edit = addStrokes(document, {stroke}, true);
        if (m_editor.layer().group() != 0) {
            edit = m_editor.layer().take(std::move(edit), order.isUnder ? LayerEnd::Bottom : LayerEnd::Top);
        } else if (order.isUnder && edit.order) {
            edit.order->pop_back();
            edit.order->insert(edit.order->begin(), stroke->id);
        }
        m_editor.push(std::move(edit), tr("Bucket fill"));
    } else {
        const bool isBeyond = !order.painting->canvas.area().contains(order.at);
        say(isBeyond ? tr("Only what lies on the canvas is filled.") : tr("There is nothing to fill here."));
    }
    startNext();
}

void BucketTool::cancel()
{
    m_isPressed = false;
    m_waiting.clear();
    m_job.cancel();
    say({});
    emit hintChanged();
    emit asideChanged();
}

bool BucketTool::takeBack()
{
    if (m_isPressed || m_waiting.empty())
        return false; // The only one is given up.
    m_waiting.pop_back();
    return true;
}

} // namespace suffuse
