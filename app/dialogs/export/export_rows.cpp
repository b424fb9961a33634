#include "app/dialogs/export/export_rows.h"

#include "app/dialogs/export/clock_box.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/numbers/decimal_box.h"
#include "app/widgets/numbers/length_units.h"
#include "model/painting/influence.h"
#include "render/image_io/image_io.h"
#include "render/renderer.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double farthestArea = 1e7; ///< canvas units

/// The area that the selected strokes ever reach.
Rect reachOf(const Document &document)
{
    Rect reach;
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (document.selection().strokes.contains(stroke->id))
            reach = reach.united(influenceOf(*stroke, stroke->driesAt()));
    return reach;
}

Rect wholeUnits(const Rect &area)
{
    if (area.isEmpty())
        return area;
    return {std::floor(area.left), std::floor(area.top), std::ceil(area.right), std::ceil(area.bottom)};
}

/// The width of the widest picture of the area that has at most so many pixels a side, and not too many in all.
int largestWidth(const Rect &area, int side)
{
    const double shape = area.height() / area.width();
    const double pixels = std::sqrt(double(maxPicturePixels) / shape);
    auto width = int(std::clamp(std::floor(std::min({double(side), side / shape, pixels})), 1.0, double(side)));
    while (width > 1 && (suffuse::heightForWidth(area, width) > side ||
                         qint64(width) * suffuse::heightForWidth(area, width) > maxPicturePixels))
        --width; // since heights are rounded
    return width;
}

} // namespace

Rect exportArea(AreaRow::Choice choice, Editor &editor, const Rect &shown)
{
    const PaintingPtr painting = editor.document().painting();
    switch (choice) {
    case AreaRow::Choice::Canvas:
        return painting->canvas.area();
    case AreaRow::Choice::Painted:
        return wholeUnits(influenceOf(*painting, painting->end()));
    case AreaRow::Choice::Selected:
        return wholeUnits(reachOf(editor.document()));
    case AreaRow::Choice::Shown:
        return shown;
    case AreaRow::Choice::Numbers:
        break;
    }
    return {};
}

Rect shownArea(const View &view)
{
    Rect area;
    for (const double x : {0.0, double(view.width)})
        for (const double y : {0.0, double(view.height)})
            area.include(view.toCanvas({x, y}));
    return area;
}

AreaRow::AreaRow(QGridLayout &grid, int row, Editor &editor, const Rect &shown, QWidget *parent) : QWidget(parent)
{
    auto *label = new QLabel(tr("Area"), parent);
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    m_box = new QComboBox(this);
    m_box->setAccessibleName(tr("Area"));
    m_box->setToolTip(tr("Which part of the canvas is drawn"));
    label->setBuddy(m_box);
    line->addWidget(m_box);
    for (const auto &[name, choice] : {std::pair(tr("Whole canvas"), Choice::Canvas),
                                       {tr("What is painted"), Choice::Painted},
                                       {tr("Selected strokes"), Choice::Selected},
                                       {tr("What the window shows"), Choice::Shown}})
        add(name, choice, exportArea(choice, editor, shown));
    m_box->addItem(tr("By numbers"), int(Choice::Numbers));
    addNumbers(parent);
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
    grid.addWidget(m_line, row + 1, 1, 1, 2);
    connect(m_box, &QComboBox::currentIndexChanged, this, &AreaRow::take);
    take();
}

void AreaRow::add(const QString &name, Choice choice, const Rect &area)
{
    if (area.isEmpty())
        return;
    m_box->addItem(name, int(choice));
    m_areas[std::size_t(choice)] = area;
}

void AreaRow::addNumbers(QWidget *parent)
{
    m_line = new QWidget(parent);
    auto *line = new QHBoxLayout(m_line);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    const std::pair<QString, QString> names[] = {
        {tr("X"), tr("Left edge")}, {tr("Y"), tr("Upper edge")}, {tr("W"), tr("Width")}, {tr("H"), tr("Height")}};
    const Display lengths = lengthDisplay(parent);
    for (std::size_t i = 0; i < 4; ++i) {
        auto *label = new QLabel(names[i].first, m_line);
        auto *box = new DecimalBox(m_line);
        box->setRange(i < 2 ? -farthestArea : 0.01, farthestArea);
        box->setDecimals(2);
        box->setDisplay(lengths);
        box->setSuffix({}); // It stands once behind all of them.
        box->setKeyboardTracking(false);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setAlignment(Qt::AlignRight);
        box->setAccessibleName(names[i].second);
        box->setToolTip(QStringLiteral("%1 (%2)").arg(names[i].second, lengths.unit.trimmed()));
        box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("−00000.00")) + 16);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        label->setBuddy(box);
        if (i > 0)
            line->addSpacing(8);
        line->addWidget(label);
        line->addWidget(box, 1);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            const QSignalBlocker blocker(m_box);
            choose(Choice::Numbers);
            emit areaChanged();
        });
        m_numbers[i] = box;
    }
    line->addWidget(new QLabel(lengths.unit.trimmed(), m_line));
}

AreaRow::Choice AreaRow::choice() const
{
    return Choice(m_box->currentData().toInt());
}

void AreaRow::choose(Choice choice)
{
    if (const int index = m_box->findData(int(choice)); index >= 0)
        m_box->setCurrentIndex(index);
}

Rect AreaRow::area() const
{
    if (choice() != Choice::Numbers)
        return m_areas[std::size_t(choice())];
    return Rect::of(m_numbers[0]->value(), m_numbers[1]->value(), m_numbers[2]->value(), m_numbers[3]->value());
}

void AreaRow::setNumbers(const Rect &area)
{
    {
        const QSignalBlocker blocker(m_box);
        choose(Choice::Numbers);
    }
    showNumbers(area);
    emit areaChanged();
}

void AreaRow::showNumbers(const Rect &area)
{
    const double numbers[] = {area.left, area.top, area.width(), area.height()};
    for (std::size_t i = 0; i < 4; ++i) {
        const QSignalBlocker blocker(m_numbers[i]);
        m_numbers[i]->setValue(numbers[i]);
    }
}

void AreaRow::take()
{
    showNumbers(area());
    emit areaChanged();
}

MomentRow::MomentRow(QGridLayout &grid, int row, Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *label = new QLabel(tr("Moment"), parent);
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    m_box = new QComboBox(this);
    m_box->addItem(tr("All dried"), int(Choice::Dried));
    m_box->addItem(tr("As it looks now"), int(Choice::Now));
    m_box->addItem(tr("At the time"), int(Choice::Time));
    m_box->setAccessibleName(tr("Moment"));
    m_box->setToolTip(tr("The finished painting, the moment that the canvas shows, or any other."));
    m_clock = new ClockBox(this);
    m_clock->setAccessibleName(tr("Time"));
    m_clock->setToolTip(tr("Minutes and seconds, as the timeline shows them: 1:02.345"));
    label->setBuddy(m_box);
    line->addWidget(m_box, 1);
    line->addWidget(m_clock);
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
    connect(m_box, &QComboBox::currentIndexChanged, this, &MomentRow::follow);
    connect(m_clock, &ClockBox::valueChanged, this,
            [this] { m_box->setCurrentIndex(m_box->findData(int(Choice::Time))); });
    // Wet paint goes on drying, so the moment changes.
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &MomentRow::follow);
    follow();
}

MomentRow::Choice MomentRow::choice() const
{
    return Choice(m_box->currentData().toInt());
}

Microseconds MomentRow::moment() const
{
    switch (choice()) {
    case Choice::Dried:
        break;
    case Choice::Now:
        return m_editor.clock().time();
    case Choice::Time:
        return m_clock->time();
    }
    return m_editor.document().painting()->end();
}

void MomentRow::choose(Choice choice, Microseconds time)
{
    if (choice == Choice::Time)
        m_clock->setTime(time);
    m_box->setCurrentIndex(m_box->findData(int(choice)));
}

void MomentRow::follow()
{
    if (choice() == Choice::Time)
        return;
    const QSignalBlocker blocker(m_clock);
    m_clock->setTime(moment());
}

SizeRow::SizeRow(QGridLayout &grid, int row, int largestSide, QWidget *parent)
    : QWidget(parent), m_largestSide(largestSide)
{
    auto *label = new QLabel(tr("Size"), parent);
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    m_width = new WholeBox(this);
    m_height = new WholeBox(this);
    for (QSpinBox *box : {m_width, m_height}) {
        box->setRange(1, largestSide);
        box->setSuffix(tr(" px"));
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // all boxes of the two columns are as wide
        line->addWidget(box, 1);
        if (box == m_width)
            line->addWidget(new QLabel(QStringLiteral("×"), this));
    }
    m_width->setAccessibleName(tr("Width in pixels"));
    m_width->setToolTip(tr("Width in pixels; the height follows."));
    m_height->setAccessibleName(tr("Height in pixels"));
    m_height->setToolTip(tr("Height in pixels; the width follows."));
    label->setBuddy(m_width);
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
    connect(m_width, &QSpinBox::valueChanged, this, &SizeRow::takeWidth);
    connect(m_height, &QSpinBox::editingFinished, this, &SizeRow::takeHeight);
}

void SizeRow::leaveRoom(int width)
{
    static_cast<QHBoxLayout *>(layout())->addSpacing(layout()->spacing() + width);
}

void SizeRow::setArea(const Rect &area, double width)
{
    m_area = area;
    limit();
    m_width->setValue(int(std::clamp(std::round(width), 1.0, double(m_width->maximum()))));
    m_scale = width / area.width();
    showHeight();
}

void SizeRow::setArea(const Rect &area)
{
    setArea(area, area.width() * m_scale);
}

void SizeRow::setLargestSide(int side)
{
    m_largestSide = side;
    if (!m_area.isEmpty())
        setArea(m_area);
}

void SizeRow::limit()
{
    const int width = largestWidth(m_area, m_largestSide);
    m_width->setMaximum(width);
    m_height->setMaximum(std::max(suffuse::heightForWidth(m_area, width), 1));
}

void SizeRow::takeWidth()
{
    m_scale = m_width->value() / m_area.width();
    showHeight();
}

void SizeRow::showHeight()
{
    m_height->setValue(suffuse::heightForWidth(m_area, m_width->value()));
}

void SizeRow::takeHeight()
{
    if (m_height->value() != suffuse::heightForWidth(m_area, m_width->value()))
        m_width->setValue(int(std::lround(m_height->value() * m_area.width() / m_area.height())));
    showHeight();
}

QString exportFolderKey(QStandardPaths::StandardLocation place)
{
    return place == QStandardPaths::MoviesLocation ? QStringLiteral("filmFolder") : QStringLiteral("exportFolder");
}

QString suggestedExportPath(const Editor &editor, QStandardPaths::StandardLocation place, const QString &ending)
{
    const QFileInfo document(editor.filePath());
    const bool isNew = editor.filePath().isEmpty();
    QString folder = settings::store().value(exportFolderKey(place)).toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = isNew ? QStandardPaths::writableLocation(place) : document.absolutePath();
    if (!QDir(folder).exists())
        folder = QDir::homePath();
    const QString name =
        isNew ? QCoreApplication::translate("suffuse::ExportDialog", "painting") : document.completeBaseName();
    return QDir(folder).filePath(name + QLatin1Char('.') + ending);
}

} // namespace suffuse
