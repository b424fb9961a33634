#include "app/dialogs/export/print_rows.h"

#include "app/session/settings/settings.h"
#include "app/widgets/numbers/decimal_box.h"
#include "model/painting/resolution.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double largest = 1e6;

} // namespace

PrintRows::PrintRows(QGridLayout &grid, int row, QSpinBox *width, QSpinBox *height, QWidget *parent)
    : QWidget(parent), m_pixelWidth(width), m_pixelHeight(height)
{
    addPrintSize(grid, row);
    addResolution(grid, row + 1);
    show();
    for (QSpinBox *box : {m_pixelWidth, m_pixelHeight})
        connect(box, &QSpinBox::valueChanged, this, [this] {
            if (!m_setting)
                m_inches = 0;
            show();
        });
    connect(m_width, &QDoubleSpinBox::valueChanged, this, [this] { takePrint(m_pixelWidth, m_width); });
    connect(m_height, &QDoubleSpinBox::valueChanged, this, [this] { takePrint(m_pixelHeight, m_height); });
    connect(m_dpi, &QDoubleSpinBox::valueChanged, this, &PrintRows::takeResolution);
    connect(m_unit, &QComboBox::currentIndexChanged, this, [this] {
        settings::store().setValue("exportUnit", m_unit->currentData().toInt());
        show();
    });
}

void PrintRows::addPrintSize(QGridLayout &grid, int row)
{
    auto *label = new QLabel(tr("Print size"), parentWidget());
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    m_width = new DecimalBox(this);
    m_height = new DecimalBox(this);
    for (DecimalBox *box : {m_width, m_height}) {
        box->setRange(0.01, largest);
        box->setKeyboardTracking(false);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // as the boxes for pixels above
        line->addWidget(box, 1);
        if (box == m_width)
            line->addWidget(new QLabel(QStringLiteral("×"), this));
    }
    m_width->setAccessibleName(tr("Width on paper"));
    m_width->setToolTip(tr("Width on paper; the height and the pixels follow."));
    m_height->setAccessibleName(tr("Height on paper"));
    m_height->setToolTip(tr("Height on paper; the width and the pixels follow."));
    m_unit = new QComboBox(this);
    m_unit->addItem(tr("mm"), int(Unit::Millimetres));
    m_unit->addItem(tr("in"), int(Unit::Inches));
    m_unit->setAccessibleName(tr("Unit"));
    m_unit->setToolTip(tr("Millimetres or inches"));
    m_unit->setCurrentIndex(settings::store().value("exportUnit").toInt() == int(Unit::Inches) ? 1 : 0);
    line->addWidget(m_unit);
    label->setBuddy(m_width);
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
}

void PrintRows::addResolution(QGridLayout &grid, int row)
{
    auto *label = new QLabel(tr("Resolution"), parentWidget());
    m_dpi = new DecimalBox(parentWidget());
    m_dpi->setRange(leastResolution, mostResolution);
    m_dpi->setDecimals(1);
    m_dpi->setValue(usualResolution); // A pixel is a unit then, as rulers and prints count it.
    m_dpi->setSuffix(tr(" dpi"));
    m_dpi->setKeyboardTracking(false);
    m_dpi->setAccessibleName(tr("Resolution"));
    m_dpi->setToolTip(tr("Pixels an inch. PNG, TIFF, JPEG and EXR files say it."));
    label->setBuddy(m_dpi);
    grid.addWidget(label, row, 0);
    grid.addWidget(m_dpi, row, 1, 1, 2);
}

double PrintRows::dpi() const
{
    return m_dpi->value();
}

void PrintRows::setDpi(double dpi)
{
    m_inches = 0;
    m_dpi->setValue(dpi);
}

void PrintRows::setPrinted(double dpi)
{
    setDpi(dpi);
    m_inches = m_pixelWidth->value() / dpi;
}

QDoubleSpinBox *PrintRows::widthBox() const
{
    return m_width;
}

QDoubleSpinBox *PrintRows::heightBox() const
{
    return m_height;
}

double PrintRows::inch() const
{
    return Unit(m_unit->currentData().toInt()) == Unit::Inches ? 1 : millimetresOfInch;
}

void PrintRows::show()
{
    const Display paper{.unit = inch() == 1 ? inchUnit() : millimetreUnit(), .resolution = dpi()};
    for (const auto &[print, pixels] : {std::pair(m_width, m_pixelWidth), std::pair(m_height, m_pixelHeight)}) {
        const QSignalBlocker blocker(print);
        print->setDecimals(inch() == 1 ? 2 : 1);
        print->setDisplay(paper);
        print->setSuffix({}); // It is chosen beside them.
        print->setValue(pixels->value() / dpi() * inch());
    }
}

void PrintRows::takePrint(QSpinBox *pixels, const QDoubleSpinBox *print)
{
    const double inches = print->value() / inch();
    m_setting = true;
    pixels->setValue(int(std::clamp(std::round(inches * dpi()), 1.0, double(pixels->maximum()))));
    emit pixels->editingFinished(); // a height then chooses the width that belongs to it
    m_setting = false;
    m_inches = m_pixelWidth->value() / dpi();
    if (pixels == m_pixelWidth && pixels->value() < pixels->maximum())
        m_inches = inches;
    show();
}

void PrintRows::takeResolution()
{
    if (m_inches > 0) {
        m_setting = true;
        m_pixelWidth->setValue(int(std::clamp(std::round(m_inches * dpi()), 1.0, double(m_pixelWidth->maximum()))));
        m_setting = false;
    }
    show();
}

} // namespace suffuse
