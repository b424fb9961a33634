#include "app/widgets/paper/canvas_section.h"

#include "app/session/files/picture_file.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"
#include "app/widgets/paper/paper_preview.h"
#include "model/painting/paper_presets.h"
#include "model/painting/resolution.h"
#include "model/painting/validate.h"
#include "render/scene/paper.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr QSize thumbnailSize{60, 24};
constexpr double thumbnailScale = 0.75; ///< logical pixels a unit

/// Place of the entry that asks for an image, after none and the presets.
int imageIndex()
{
    return int(paperPresets().size()) + 1;
}

/// Place of the entry that is there only while the paper is none of the others. Choosing it changes nothing.
int customIndex()
{
    return imageIndex() + 1;
}

int indexOf(const Paper &paper)
{
    switch (paper.kind) {
    case PaperKind::None:
        return 0;
    case PaperKind::Image:
        return imageIndex();
    case PaperKind::Procedural:
        break;
    }
    const int preset = presetOf(paper);
    return preset < 0 ? customIndex() : preset + 1;
}
} // namespace

CanvasSection::CanvasSection(QWidget *parent) : QWidget(parent)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(sectionTitle(tr("Canvas"), this));
    addSize(*addFieldGrid(*column));

    auto *head = new QHBoxLayout;
    head->addWidget(sectionTitle(tr("Background"), this), 1);
    m_swatch = new ColourSwatch(this);
    m_swatch->setAccessibleName(tr("Background"));
    m_swatch->setToolTip(tr("Background colour. Click: white."));
    head->addWidget(m_swatch);
    column->addSpacing(8);
    column->addLayout(head);
    m_background = new ColourRows(true, this);
    column->addWidget(m_background);
    connect(m_swatch, &ColourSwatch::clicked, this,
            [this] { change([](Canvas &c) { c.background = Colour{}; }, tr("Change background")); });
    connect(m_background, &ColourRows::edited, this, [this](int channel, double value, ValueEntry *entry) {
        change([=](Canvas &c) { ColourRows::channelOf(c.background, channel) = float(value); }, tr("Change background"),
               entry);
    });
    connect(m_background, &ColourRows::refused, this, &CanvasSection::refused);

    column->addSpacing(8);
    column->addWidget(sectionTitle(tr("Paper"), this));
    addPaper(*addFieldGrid(*column));
    refresh();
}

void CanvasSection::addSize(QGridLayout &grid)
{
    const auto add = [&](int row, const QString &name, const QString &tip, double Canvas::*member, ValueEntry &steps) {
        auto *label = new QLabel(name, this);
        auto *field = new NumberField(this);
        field->setRange(0.001, 1e6);
        field->setDisplay(lengthDisplay());
        field->setAccessibleName(name);
        field->setToolTip(tip);
        label->setBuddy(field);
        grid.addWidget(label, row, 0);
        grid.addWidget(field, row, 2);
        connect(field, &NumberField::refused, this, &CanvasSection::refused);
        const auto take = [=, this](double value, ValueEntry *entry) {
            const double side = m_isPaper ? std::max(1.0, std::round(value)) : value;
            change([=](Canvas &c) { c.*member = side; }, tr("Resize canvas"), entry);
        };
        connect(field, &NumberField::entered, this, [=](double value) { take(value, nullptr); });
        // A tenth of a size is rarely whole, and nobody steps to a part of a pixel.
        connect(field, &NumberField::stepped, this, [=, &steps](double value) {
            steps.noteStep();
            take(value < 10 ? value : std::round(value), &steps);
        });
        return field;
    };
    m_width = add(0, tr("Width"), tr("Width of the canvas in units; a unit is a pixel at 100 %."), &Canvas::width,
                  m_widthSteps);
    m_height = add(1, tr("Height"), tr("Height of the canvas in units; a unit is a pixel at 100 %."), &Canvas::height,
                   m_heightSteps);
    m_onPaper = quietLabel({}, this);
    grid.addWidget(m_onPaper, 2, 0, 1, 3);
}

void CanvasSection::addPaper(QGridLayout &grid)
{
    auto *paperLabel = new QLabel(tr("Texture"), this);
    m_paper = new QComboBox(this);
    m_paper->addItem(tr("None"));
    for (const PaperPreset &preset : paperPresets())
        m_paper->addItem(titleOf(preset));
    m_paper->addItem(tr("Image…"));
    m_paper->setIconSize(thumbnailSize);
    m_paper->setAccessibleName(tr("Texture"));
    m_paper->setToolTip(tr("The paper's grain, which granulating strokes show."));
    paperLabel->setBuddy(m_paper);
    grid.addWidget(paperLabel, 0, 0);
    grid.addWidget(m_paper, 0, 1, 1, 2);
    connect(m_paper, &QComboBox::activated, this, &CanvasSection::choosePaper);

    m_image = new QPushButton(tr("Choose &Image…"), this);
    m_image->setToolTip(tr("Take the grain from another picture file."));
    grid.addWidget(m_image, 1, 1, 1, 2);
    connect(m_image, &QPushButton::clicked, this, &CanvasSection::chooseImagePaper);

    m_seedLabel = new QLabel(tr("Seed"), this);
    m_seed = new NumberField(this);
    m_seed->setInteger(true);
    m_seed->setRange(0, 4294967295.0);
    m_seed->setStep(1);
    m_seed->setAccessibleName(tr("Seed"));
    m_seed->setToolTip(tr("Another number gives another grain."));
    m_seedLabel->setBuddy(m_seed);
    grid.addWidget(m_seedLabel, 2, 0);
    grid.addWidget(m_seed, 2, 2);
    connect(m_seed, &NumberField::refused, this, &CanvasSection::refused);
    const auto takeSeed = [this](double value, ValueEntry *entry) {
        change([=](Canvas &c) { c.paper.seed = std::uint32_t(value); }, tr("Change paper"), entry);
    };
    connect(m_seed, &NumberField::entered, this, [=](double value) { takeSeed(value, nullptr); });
    connect(m_seed, &NumberField::stepped, this, [=, this](double value) {
        m_seedSteps.noteStep();
        takeSeed(value, &m_seedSteps);
    });

    m_scale = new SliderField(
        {.name = tr("Scale"),
         .toolTip = tr("Size of the coarsest grain or of a thread in units, or units per pixel of the image."),
         .display = lengthDisplay(),
         .minimum = 1e-6,
         .maximum = 1e6,
         .sliderMinimum = 0.1,
         .sliderMaximum = 400,
         .logarithmic = true,
         .defaultValue = Paper{}.scale},
        grid, 3, this);
    m_strength = new SliderField(specOf(Quantity::PaperStrength), grid, 4, this);
    const auto connectField = [this](SliderField *field, float Paper::*member) {
        connect(field, &SliderField::refused, this, &CanvasSection::refused);
        connect(field, &SliderField::edited, this, [this, member](double value, ValueEntry *entry) {
            change([=](Canvas &c) { c.paper.*member = float(value); }, tr("Change paper"), entry);
        });
    };
    connectField(m_scale, &Paper::scale);
    connectField(m_strength, &Paper::strength);
}

void CanvasSection::choosePaper(int index)
{
    if (index == imageIndex())
        return chooseImagePaper();
    if (index == customIndex())
        return;
    Paper paper = m_canvas.paper;
    if (index > 0)
        paper = paperOf(paperPresets()[std::size_t(index - 1)], paper.seed);
    else
        paper.kind = PaperKind::None, paper.image.reset();
    change([&](Canvas &c) { c.paper = paper; }, tr("Change paper"));
}

void CanvasSection::chooseImagePaper()
{
    Paper paper = m_canvas.paper;
    if (!chooseImage(paper)) {
        refresh();
        return;
    }
    if (m_canvas.paper.kind != PaperKind::Image)
        paper.scale = 1;
    change([&](Canvas &c) { c.paper = paper; }, tr("Change paper"));
}

void CanvasSection::showThumbnails()
{
    const double ratio = devicePixelRatioF();
    const auto presets = paperPresets();
    for (int i = 0; i < int(presets.size()); ++i) {
        const QSize size = thumbnailSize * ratio;
        QImage image = paperPreview(paperOf(presets[std::size_t(i)]), size, thumbnailScale * ratio);
        image.setDevicePixelRatio(ratio);
        m_paper->setItemIcon(i + 1, QPixmap::fromImage(image));
    }
}

void CanvasSection::showEvent(QShowEvent *event)
{
    if (m_paper->itemIcon(1).isNull())
        showThumbnails();
    QWidget::showEvent(event);
}

bool CanvasSection::chooseImage(Paper &paper)
{
    const QString path = choosePicture(this, tr("Paper image"));
    if (path.isEmpty())
        return false;
    const Result<EncodedImage> image = readPictureFile(path);
    if (!image) {
        emit refused(image.error());
        return false;
    }
    paper.image = *image;
    paper.kind = PaperKind::Image;
    if (const auto texture = paperTexture(paper); !texture) {
        emit refused(tr("%1 cannot be used as paper: %2").arg(path, texture.error()));
        return false;
    }
    return true;
}

void CanvasSection::change(const std::function<void(Canvas &)> &change, const QString &undoText, ValueEntry *entry)
{
    Canvas canvas = m_canvas;
    change(canvas);
    if (const QString problem = problemOf(canvas); !problem.isEmpty()) {
        emit refused(problem);
        refresh();
        return;
    }
    m_canvas = canvas;
    refresh();
    emit edited(canvas, undoText, entry);
}

void CanvasSection::setCanvas(const Canvas &canvas)
{
    m_canvas = canvas;
    refresh();
}

void CanvasSection::setResolution(double resolution)
{
    m_resolution = resolution;
    refresh();
}

/// "120 × 90 mm at 150 dpi"; empty where it is not said.
QString CanvasSection::sizeOnPaper() const
{
    if (!isResolution(m_resolution))
        return {};
    const bool isMetric = QLocale::system().measurementSystem() == QLocale::MetricSystem;
    const auto side = [&](double units) {
        const double inches = units / m_resolution;
        return QLocale().toString(isMetric ? inches * millimetresOfInch : inches, 'f', isMetric ? 1 : 2);
    };
    return (isMetric ? tr("%1 × %2 mm at %3 dpi") : tr("%1 × %2 in at %3 dpi"))
        .arg(side(m_canvas.width), side(m_canvas.height), QLocale().toString(m_resolution));
}

void CanvasSection::setSideDisplay(const Display &display, bool isPaper)
{
    m_isPaper = isPaper;
    for (NumberField *field : {m_width, m_height})
        field->setDisplay(display);
    refresh();
}

void CanvasSection::refresh()
{
    const Paper &paper = m_canvas.paper;
    m_width->setValue(m_canvas.width);
    m_height->setValue(m_canvas.height);
    m_onPaper->setText(sizeOnPaper());
    m_onPaper->setVisible(!m_onPaper->text().isEmpty());
    m_swatch->setColour(m_canvas.background);
    m_background->setColour(m_canvas.background);
    if (indexOf(paper) != customIndex())
        m_paper->removeItem(customIndex());
    else if (m_paper->count() == customIndex())
        m_paper->addItem(tr("Custom"));
    m_paper->setCurrentIndex(indexOf(paper));
    m_image->setVisible(paper.kind == PaperKind::Image);
    m_seedLabel->setVisible(paper.kind == PaperKind::Procedural);
    m_seed->setVisible(paper.kind == PaperKind::Procedural);
    m_seed->setValue(double(paper.seed));
    m_scale->setVisible(paper.kind != PaperKind::None);
    m_scale->setValue(double(paper.scale));
    m_strength->setVisible(paper.kind != PaperKind::None);
    m_strength->setValue(double(paper.strength));
}

} // namespace suffuse
