<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Bench</name>
    <message>
        <source>stopped before all was measured</source>
        <translation>在全部测量完成之前已停止</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>无法创建临时文件夹：%1。请将 TMPDIR 设为可写入的文件夹。</translation>
    </message>
    <message>
        <source>there is no stroke to drag in this painting</source>
        <translation>此画作中没有可拖动的笔画</translation>
    </message>
    <message>
        <source>measuring %1</source>
        <translation>正在测量 %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>对照</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>画作</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>backend</source>
        <translation>后端</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>中位数 ms</translation>
    </message>
    <message>
        <source>min ms</source>
        <translation>最小 ms</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Ink wash</source>
        <translation>水墨</translation>
    </message>
    <message>
        <source>Watercolour edge</source>
        <translation>水彩深边</translation>
    </message>
    <message>
        <source>Soft airbrush</source>
        <translation>柔和喷枪</translation>
    </message>
    <message>
        <source>Flat marker</source>
        <translation>平头马克笔</translation>
    </message>
    <message>
        <source>Dry chalk</source>
        <translation>干粉笔</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>铅笔</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>毛笔</translation>
    </message>
    <message>
        <source>Dry brush</source>
        <translation>干笔</translation>
    </message>
    <message>
        <source>Ink splash</source>
        <translation>泼墨</translation>
    </message>
    <message>
        <source>Broad nib</source>
        <translation>宽头笔尖</translation>
    </message>
    <message>
        <source>Flat wash</source>
        <translation>平涂淡彩</translation>
    </message>
    <message>
        <source>Granulating wash</source>
        <translation>颗粒淡彩</translation>
    </message>
    <message>
        <source>Wet in wet</source>
        <translation>湿画法</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>罩染</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>双色</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>炭笔</translation>
    </message>
    <message>
        <source>Pastel</source>
        <translation>粉彩</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>水粉</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>辉光</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>墨水</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>水彩</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>干性画材</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平涂</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>喷枪</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Round wash</source>
        <translation>圆头淡彩</translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>&amp;OK</source>
        <translation>确定(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>是(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>重试(&amp;R)</translation>
    </message>
    <message>
        <source>Restore &amp;Defaults</source>
        <translation>恢复默认值(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Show Details...</source>
        <translation>显示详细信息(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Hide Details...</source>
        <translation>隐藏详细信息(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>ChoosePicture</name>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Pictures and diffusion curves</source>
        <translation>图片与扩散曲线</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>%1: cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1：无法读取（%2）。请检查文件名及其权限。</translation>
    </message>
    <message>
        <source>%1: has more than 2 GB; that is more than can be opened</source>
        <translation>%1：超过 2 GB，无法打开</translation>
    </message>
    <message>
        <source>  bytes     %1</source>
        <translation>  字节      %1</translation>
    </message>
    <message>
        <source>  canvas    %1 × %2</source>
        <translation>  画布      %1 × %2</translation>
    </message>
    <message>
        <source>  on paper  %1 × %2 mm, %3 units an inch</source>
        <translation>  纸上大小  %1 × %2 毫米，每英寸 %3 个单位</translation>
    </message>
    <message>
        <source>  strokes   %1</source>
        <translation>  笔画      %1</translation>
    </message>
    <message>
        <source>  segments  %1</source>
        <translation>  线段      %1</translation>
    </message>
    <message>
        <source>  bounds    none: nothing is painted</source>
        <translation>  边界      无：没有绘制内容</translation>
    </message>
    <message>
        <source>  bounds    x %1, y %2, %3 × %4</source>
        <translation>  边界      x %1, y %2, %3 × %4</translation>
    </message>
    <message>
        <source>  duration  %1 s</source>
        <translation>  时长      %1 秒</translation>
    </message>
    <message>
        <source>  chunk     %1, %2 bytes</source>
        <translation>  数据块    %1，%2 字节</translation>
    </message>
    <message>
        <source>%1not available: %2</source>
        <translation>%1不可用：%2</translation>
    </message>
    <message>
        <source>Tells what a painting or a recording holds.</source>
        <translation>显示画作或笔迹记录的内容。</translation>
    </message>
    <message>
        <source>Prints JSON (docs/cli.md).</source>
        <translation>输出 JSON（docs/cli.md）。</translation>
    </message>
    <message>
        <source>The backends and devices there are, and why one is missing.</source>
        <translation>可用的后端和设备，以及某个后端缺失的原因。</translation>
    </message>
    <message>
        <source>give a file, or --backends</source>
        <translation>请给出文件，或使用 --backends</translation>
    </message>
    <message>
        <source>draw a painting into an image file</source>
        <translation>将画作绘制为图像文件</translation>
    </message>
    <message>
        <source>what a file holds; the backends there are</source>
        <translation>文件的内容；可用的后端</translation>
    </message>
    <message>
        <source>between documents, the text form and recordings</source>
        <translation>在文档、文本形式和笔迹记录之间转换</translation>
    </message>
    <message>
        <source>what lies at a point of the canvas</source>
        <translation>画布上某点处的内容</translation>
    </message>
    <message>
        <source>compare the backends with the reference</source>
        <translation>将各后端与参考实现比较</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli COMMAND [options] …</source>
        <translation>用法：suffuse-cli 命令 [选项] …</translation>
    </message>
    <message>
        <source>%1: there is no such command. See suffuse-cli --help.</source>
        <translation>%1：没有此命令。参见 suffuse-cli --help。</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>显示此帮助。</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>参数过少</translation>
    </message>
    <message>
        <source>one argument too many: %1</source>
        <translation>多余的参数：%1</translation>
    </message>
    <message>
        <source>%1: %2. See suffuse-cli %1 --help.</source>
        <translation>%1：%2。参见 suffuse-cli %1 --help。</translation>
    </message>
    <message>
        <source>standard output cannot be written: %1</source>
        <translation>无法写入标准输出：%1</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>正在绘制</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>已停止；未写入任何内容</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>内存不足以容纳 %1 × %2 像素。请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>--area %1: give X,Y,W,H in canvas units, W and H above 0</source>
        <translation>--area %1：请以画布单位给出 X,Y,W,H，W 和 H 须大于 0</translation>
    </message>
    <message>
        <source>--size %1: give WxH or W in pixels, e.g. 1024x768</source>
        <translation>--size %1：请以像素给出 WxH 或 W，例如 1024x768</translation>
    </message>
    <message>
        <source>--scale %1: give pixels a unit, above 0, e.g. 2</source>
        <translation>--scale %1：请给出每单位的像素数，须大于 0，例如 2</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a smaller --size, --scale or --area</source>
        <translation>%1 × %2 像素的图片太大：最多 %3 百万像素。请选择较小的 --size、--scale 或 --area</translation>
    </message>
    <message>
        <source>%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale or --area</source>
        <translation>每单位 %1 像素超出范围：0.001 到 1e9。请选择其他 --size、--scale 或 --area</translation>
    </message>
    <message>
        <source>give --size or --scale, not both</source>
        <translation>--size 与 --scale 只能给出其一</translation>
    </message>
    <message>
        <source>--size %1: the picture is scaled uniformly, so a width of %2 has the height %3: use --size %2x%3</source>
        <translation>--size %1：图片等比缩放，宽度 %2 对应高度 %3：请使用 --size %2x%3</translation>
    </message>
    <message>
        <source>--time %1: give a moment in seconds, e.g. 1.5</source>
        <translation>--time %1：请以秒给出时刻，例如 1.5</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu, cuda or reference</source>
        <translation>--backend %1：请给出 auto、cpu、cuda 或 reference</translation>
    </message>
    <message>
        <source>--threads %1: give a number from 1 to 1024</source>
        <translation>--threads %1：请给出 1 到 1024 的数字</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message>
        <source>stroke %1, %2</source>
        <translation>笔画 %1，%2</translation>
    </message>
    <message>
        <source>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (red, yellow, blue, opacity)
  after it: RYB %7, RGB %8
</source>
        <translation>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6（红、黄、蓝、不透明度）
  混合后：RYB %7，RGB %8
</translation>
    </message>
    <message>
        <source>  fill: φ %1, share %2
</source>
        <translation>  填充：φ %1，占比 %2
</translation>
    </message>
    <message>
        <source>  segment %1: φ %2, share %3
</source>
        <translation>  线段 %1：φ %2，占比 %3
</translation>
    </message>
    <message>
        <source>at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6
</source>
        <translation>位于 %1, %2，%3 秒：纸张 η %4，背景 RYB %5，RGB %6
</translation>
    </message>
    <message>
        <source>no stroke reaches this point
</source>
        <translation>没有笔画到达此点
</translation>
    </message>
    <message>
        <source>Tells what lies at a point of the canvas, stroke by stroke from bottom to top. X and Y are in canvas units.</source>
        <translation>从下到上逐笔画显示画布上某点处的内容。X 和 Y 以画布单位计。</translation>
    </message>
    <message>
        <source>The moment, in seconds (default: the end).</source>
        <translation>时刻（秒，默认：结束时）。</translation>
    </message>
    <message>
        <source>%1 %2: give X and Y as numbers, in canvas units</source>
        <translation>%1 %2：请以画布单位给出数字 X 和 Y</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone; scales uniformly.</source>
        <translation>像素：WxH，或仅 W；等比缩放。</translation>
    </message>
    <message>
        <source>Pixels a canvas unit (default 1).</source>
        <translation>每画布单位的像素数（默认 1）。</translation>
    </message>
    <message>
        <source>Part of the canvas, in canvas units (default: all of it).</source>
        <translation>画布的一部分，以画布单位计（默认：全部）。</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: the end).</source>
        <translation>要绘制的时刻（秒，默认：结束时）。</translation>
    </message>
    <message>
        <source>No background: alpha holds the coverage.</source>
        <translation>无背景：alpha 保存覆盖率。</translation>
    </message>
    <message>
        <source>8, 16, half or float (default: the format&apos;s usual one).</source>
        <translation>8、16、half 或 float（默认：该格式常用的位深）。</translation>
    </message>
    <message>
        <source>auto, cpu, cuda or reference.</source>
        <translation>auto、cpu、cuda 或 reference。</translation>
    </message>
    <message>
        <source>Number of threads (default: one a core).</source>
        <translation>线程数（默认：每核心一个）。</translation>
    </message>
    <message>
        <source>Prints times and counts as JSON.</source>
        <translation>以 JSON 输出时间和计数。</translation>
    </message>
    <message>
        <source>--depth %1: give 8, 16, half or float</source>
        <translation>--depth %1：请给出 8、16、half 或 float</translation>
    </message>
    <message>
        <source>Draws a painting or a recording into an image file.</source>
        <translation>将画作或笔迹记录绘制为图像文件。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the picture to write</source>
        <translation>缺少 -o OUT：请指定要写入的图片</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference R %3, G %4, B %5</source>
        <translation>%1 与 %2：最大差异 R %3，G %4，B %5</translation>
    </message>
    <message>
        <source>  at pixel %1, %2: RGB %3 and %4</source>
        <translation>  像素 %1, %2 处：RGB %3 与 %4</translation>
    </message>
    <message>
        <source>  %1 of %2 pixels over 1/512</source>
        <translation>  %2 个像素中有 %1 个超过 1/512</translation>
    </message>
    <message>
        <source>  %1 pixels that are no numbers</source>
        <translation>  %1 个像素不是数字</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference in 8 bits %3, at pixel %4, %5</source>
        <translation>%1 与 %2：8 位下最大差异 %3，位于像素 %4, %5</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, at %4 s</source>
        <translation>%1，%2 × %3 像素，%4 秒</translation>
    </message>
    <message>
        <source>within the contract</source>
        <translation>符合约定</translation>
    </message>
    <message>
        <source>OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends</source>
        <translation>超出约定：与参考实现相差 1/512，后端之间相差 8 位的 1 级</translation>
    </message>
    <message>
        <source>Draws a painting on every backend there is and on the reference, and compares the pictures.</source>
        <translation>用所有可用后端和参考实现绘制画作，并比较图片。</translation>
    </message>
    <message>
        <source>Prints the rows as a JSON array.</source>
        <translation>以 JSON 数组形式输出各行。</translation>
    </message>
    <message>
        <source>Measures on this document instead of a generated painting of figure 11f&apos;s size.</source>
        <translation>在此文档上测量，而不是在与图 11f 大小相当的生成画作上测量。</translation>
    </message>
    <message>
        <source>all: every backend that can run here, one after the other.</source>
        <translation>all：依次测量此处可运行的所有后端。</translation>
    </message>
    <message>
        <source>Numbers of threads; several: full renders with each (default: 1, and one a core).</source>
        <translation>线程数；给出多个时，每个都完整渲染（默认：1，以及每核一个）。</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).</source>
        <translation>像素：宽x高，或仅给宽（默认：每单位 1 px，完整渲染另加 2.8125 px）。</translation>
    </message>
    <message>
        <source>Names of rows, with commas between: takes these only.</source>
        <translation>行的名称，以逗号分隔：只测量这些行。</translation>
    </message>
    <message>
        <source>Runs a row (default: 9).</source>
        <translation>每行的运行次数（默认：9）。</translation>
    </message>
    <message>
        <source>Full renders of all thirteen sizes of the paper&apos;s Table 2 too.</source>
        <translation>同时以论文表 2 的全部十三种大小完整渲染。</translation>
    </message>
    <message>
        <source>Range of the generated strokes&apos; spread, in units (default: 6 20).</source>
        <translation>生成笔画的扩散距离范围，以单位计（默认：6 20）。</translation>
    </message>
    <message>
        <source>Segments of the growth rows (default: 1000,10000,100000).</source>
        <translation>增长各行的线段数（默认：1000,10000,100000）。</translation>
    </message>
    <message>
        <source>A growth row of 1000000 segments too.</source>
        <translation>另加一行 1000000 条线段的增长测量。</translation>
    </message>
    <message>
        <source>Width of the generated painting&apos;s canvas (default: 1024).</source>
        <translation>生成画作的画布宽度（默认：1024）。</translation>
    </message>
    <message>
        <source>Height of the generated painting&apos;s canvas (default: 768).</source>
        <translation>生成画作的画布高度（默认：768）。</translation>
    </message>
    <message>
        <source>Scale of the generated strokes (default: width / 1024).</source>
        <translation>生成笔画的比例（默认：宽度 / 1024）。</translation>
    </message>
    <message>
        <source>--%1 %2: give whole numbers from %3 to %4</source>
        <translation>--%1 %2：请给出 %3 到 %4 之间的整数</translation>
    </message>
    <message>
        <source>--%1 %2: give a number above 0, at most %3</source>
        <translation>--%1 %2：请给出大于 0 且不超过 %3 的数</translation>
    </message>
    <message>
        <source>--spread %1: give two numbers, e.g. --spread 6 20</source>
        <translation>--spread %1：请给出两个数，例如 --spread 6 20</translation>
    </message>
    <message>
        <source>--devices %1: give all, or leave it out</source>
        <translation>--devices %1：请给出 all，或省略此选项</translation>
    </message>
    <message>
        <source>--only %1: the rows are %2</source>
        <translation>--only %1：可用的行有 %2</translation>
    </message>
    <message>
        <source>Measures how fast this machine draws: the figures of docs/performance.md.</source>
        <translation>测量本机的绘制速度：即 docs/performance.md 中的数据。</translation>
    </message>
    <message>
        <source>measure how fast this machine draws</source>
        <translation>测量本机的绘制速度</translation>
    </message>
    <message>
        <source>--devices %1: give all, or a number of GPUs, at least 1</source>
        <translation>--devices %1：请给出 all 或 GPU 数量（至少 1）</translation>
    </message>
    <message>
        <source>--devices is for CUDA: use it with --backend cuda</source>
        <translation>--devices 仅用于 CUDA：请与 --backend cuda 一起使用</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the picture, all or a number (default 1).</source>
        <translation>使用 CUDA 时共同绘制图像的 GPU：all 或数量（默认 1）。</translation>
    </message>
    <message>
        <source>draw a painting while it is painted, as frames</source>
        <translation>绘制画作的作画过程，输出为各帧图片</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>剩余 %n 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>Frames a second (default 25).</source>
        <translation>每秒帧数（默认 25）。</translation>
    </message>
    <message>
        <source>Length in seconds (default 10).</source>
        <translation>时长，以秒计（默认 10）。</translation>
    </message>
    <message>
        <source>Seconds that are kept of a pause in the painting (default 0.5).</source>
        <translation>作画过程中的停顿所保留的秒数（默认 0.5）。</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the frames, all or a number (default 1).</source>
        <translation>使用 CUDA 时分担各帧的 GPU：all 或数量（默认 1）。</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to 1000000</source>
        <translation>--%1 %2：请给出 %3 到 1000000 之间的数</translation>
    </message>
    <message>
        <source>%1 frames are too many: at most %2. Choose a smaller --fps or --duration</source>
        <translation>%1 帧太多：最多 %2 帧。请选择较小的 --fps 或 --duration</translation>
    </message>
    <message>
        <source>Draws a painting while it is painted, frame by frame.</source>
        <translation>逐帧绘制画作的作画过程。</translation>
    </message>
    <message>
        <source>--brush %1: there is no such brush nor file; choose a file or one of %2</source>
        <translation>--brush %1：没有此画笔或文件；请选择文件或 %2 之一</translation>
    </message>
    <message>
        <source>Frames with their number, film/%05d.png; or film.webp, .webm or .mp4.</source>
        <translation>带编号的各帧 film/%05d.png；或 film.webp、.webm、.mp4。</translation>
    </message>
    <message>
        <source>WebP: plays once instead of again and again.</source>
        <translation>WebP：只播放一次，不循环。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the frames or the film to write</source>
        <translation>缺少 -o OUT：请指定要写入的各帧或影片的名称</translation>
    </message>
    <message>
        <source>Leaves out what lies beside the picture: preview, view, undo history.</source>
        <translation>不写入图像以外的内容：预览、视图、撤销历史。</translation>
    </message>
    <message>
        <source>Of a damaged document takes what is whole, and says what is missing.</source>
        <translation>对损坏的文档取其完好的部分，并说明缺少什么。</translation>
    </message>
    <message>
        <source>%1: is damaged; --salvage writes what is whole of it</source>
        <translation>%1：已损坏；--salvage 可写出其完好的部分</translation>
    </message>
    <message>
        <source>segments added: %1</source>
        <translation>新增线段：%1</translation>
    </message>
    <message>
        <source>segments removed: %1</source>
        <translation>删除线段：%1</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same painting</source>
        <translation>%1 与 %2 是同一幅画作</translation>
    </message>
    <message>
        <source>%1, segments: %2</source>
        <translation>%1，线段：%2</translation>
    </message>
    <message>
        <source>%1: from place %2 to %3</source>
        <translation>%1：从位置 %2 到 %3</translation>
    </message>
    <message>
        <source>Compares two paintings and tells what was added, removed and changed from A to B.</source>
        <translation>比较两幅画作，说明从 A 到 B 新增、删除和更改了什么。</translation>
    </message>
    <message>
        <source>only one of the two can be standard input</source>
        <translation>两者中只能有一个是标准输入</translation>
    </message>
    <message>
        <source>A picture that shows where: B pale, added strokes green, removed ones orange, changed and moved ones blue.</source>
        <translation>显示差异所在的图片：B 变淡，新增的笔画为绿色，删除的为橙色，更改和移动的为蓝色。</translation>
    </message>
    <message>
        <source>--%1 is for the picture; give -o OUT too</source>
        <translation>--%1 用于图片；请同时给出 -o OUT</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>上次的视图</translation>
    </message>
    <message>
        <source>undo history</source>
        <translation>撤销历史</translation>
    </message>
    <message>
        <source>colour profile</source>
        <translation>颜色配置文件</translation>
    </message>
    <message>
        <source>size on paper</source>
        <translation>纸上大小</translation>
    </message>
    <message>
        <source>unknown to this version, kept</source>
        <translation>此版本不认识，予以保留</translation>
    </message>
    <message>
        <source>  chunk     %1 at byte %2 is damaged: %3</source>
        <translation>  数据块    %1（位于字节 %2）已损坏：%3</translation>
    </message>
    <message>
        <source>  paper     %1</source>
        <translation>  纸张      %1</translation>
    </message>
    <message>
        <source>what differs between two paintings, and where</source>
        <translation>两幅画作有何不同，在哪里</translation>
    </message>
    <message>
        <source>what was not saved when the editor ended</source>
        <translation>编辑器结束时未保存的内容</translation>
    </message>
    <message>
        <source>in use by a running Suffuse</source>
        <translation>正被运行中的 Suffuse 使用</translation>
    </message>
    <message>
        <source>There is nothing to recover.
</source>
        <translation>没有可恢复的内容。
</translation>
    </message>
    <message>
        <source>Lists what was painted and not saved when Suffuse ended unexpectedly, or writes one of it to a file.</source>
        <translation>列出 Suffuse 意外结束时已绘制而未保存的内容，或将其中之一写入文件。</translation>
    </message>
    <message>
        <source>Lists what there is; the same as no ID.</source>
        <translation>列出现有内容；与不给 ID 相同。</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json.</source>
        <translation>要写入的文件：.suffuse 或 .json。</translation>
    </message>
    <message>
        <source>give an ID and -o OUT, or neither</source>
        <translation>请同时给出 ID 和 -o OUT，或都不给</translation>
    </message>
    <message>
        <source>%1: there is no such journal to recover. See suffuse-cli recover --list.</source>
        <translation>%1：没有可恢复的此日志。请见 suffuse-cli recover --list。</translation>
    </message>
    <message>
        <source>The brush that recordings and drawings are painted with: a name, or a brush file.</source>
        <translation>绘制记录和图形所用的画笔：名称或画笔文件。</translation>
    </message>
    <message>
        <source>%1: is IN itself, which would be lost; give OUT another name</source>
        <translation>%1：就是 IN 本身，会丢失；请为 OUT 另取名称</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read; -: standard input.</source>
        <translation>要读取的画作、记录或图形；-：标准输入。</translation>
    </message>
    <message>
        <source>The painting before; -: standard input.</source>
        <translation>之前的画作；-：标准输入。</translation>
    </message>
    <message>
        <source>The painting after; -: standard input.</source>
        <translation>之后的画作；-：标准输入。</translation>
    </message>
    <message>
        <source>How far right of the canvas&apos; left edge, in canvas units.</source>
        <translation>距画布左边缘的距离，以画布单位计。</translation>
    </message>
    <message>
        <source>How far below the canvas&apos; upper edge, in canvas units.</source>
        <translation>距画布上边缘的距离，以画布单位计。</translation>
    </message>
    <message>
        <source>Which one, as the list names it.</source>
        <translation>列表中的编号。</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli %1 [options]</source>
        <translation>用法：suffuse-cli %1 [选项]</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 给出了两次；请只给一次</translation>
    </message>
    <message>
        <source>--time %1: nothing is painted before %2 s</source>
        <translation>--time %1：%2 秒之前没有任何绘画</translation>
    </message>
    <message>
        <source>--format is for an OUT of -; the ending of %1 chooses the format</source>
        <translation>--format 仅在 OUT 为 - 时使用；%1 的格式由扩展名决定</translation>
    </message>
    <message>
        <source>--brush is ignored: the strokes of %1 have their looks already</source>
        <translation>--brush 被忽略：%1 的笔画已有自己的外观</translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1：%n 个笔画无一完好；请打开其备份</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2: %3, %4 removed, %5 changed, %6 moved</source>
        <translation>%1 → %2：%3，移除 %4，更改 %5，移动 %6</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>新增 %n 个笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help COMMAND. An input of - is standard input.
Exit codes: 0 done, 1 the work failed, 2 wrong usage.</source>
        <translation>suffuse-cli 命令 --help 列出该命令的选项，suffuse-cli help 命令 亦然。输入为 - 表示标准输入。
退出码：0 完成，1 失败，2 用法错误。</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json; -: standard output.</source>
        <translation>要写入的文件：.suffuse 或 .json；-：标准输出。</translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  省略 %n 个占比低于 %1 的线段（--all）
</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists segments with shares below a millionth, too.</source>
        <translation>也列出占比低于百万分之一的线段。</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n 个笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>-o %1: what is recovered is a painting: give a name that ends in .suffuse or .json. suffuse-cli render draws it then</source>
        <translation>-o %1：恢复的是一幅画作：请给出以 .suffuse 或 .json 结尾的名称，然后用 suffuse-cli render 绘制</translation>
    </message>
    <message>
        <source>The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: its layers; -: standard output.</source>
        <translation>图片：.png、.tiff、.exr、.jpg、.webp 或 .pfm；.ora 或 .psd：其图层；-：标准输出。</translation>
    </message>
    <message>
        <source>With -o -: png, tiff, exr, jpg, webp or pfm (default: png).</source>
        <translation>与 -o - 同用：png、tiff、exr、jpg、webp 或 pfm（默认 png）。</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100.</source>
        <translation>JPEG 与 WebP 的质量，1 到 100（默认 92）；WebP 为 100 时无损。</translation>
    </message>
    <message>
        <source>Pixels an inch, as the file says it (default: what makes the picture as large on paper as IN says that it is; else it says nothing).</source>
        <translation>文件中标明的每英寸像素数（默认：使图片在纸上与 IN 标明的大小相同的值；否则不标明）。</translation>
    </message>
    <message>
        <source>--format is for -o -; the ending of %1 chooses the format</source>
        <translation>--format 用于 -o -；%1 的格式由扩展名决定</translation>
    </message>
    <message>
        <source>--stats and -o - both write to standard output; give one</source>
        <translation>--stats 与 -o - 都写到标准输出；请只用其一</translation>
    </message>
    <message>
        <source>standard output is a terminal, which shows no pictures; lead it into a file or a program</source>
        <translation>标准输出是终端，无法显示图片；请重定向到文件或程序</translation>
    </message>
    <message>
        <source>--format %1: give one of %2</source>
        <translation>--format %1：请给出 %2 之一</translation>
    </message>
    <message>
        <source>--quality %1: give a whole number from 1 to 100</source>
        <translation>--quality %1：请给出 1 到 100 的整数</translation>
    </message>
    <message>
        <source>--quality is ignored: %1 loses nothing</source>
        <translation>--quality 被忽略：%1 是无损的</translation>
    </message>
    <message>
        <source>--dpi %1: give a number from 1 to 10000, e.g. 300</source>
        <translation>--dpi %1：请给出 1 到 10000 的数，例如 300</translation>
    </message>
    <message>
        <source>--dpi is ignored: %1 files hold no resolution</source>
        <translation>--dpi 被忽略：%1 文件不含分辨率</translation>
    </message>
    <message>
        <source>  segment %1 fades: φ %2, which leaves %3
</source>
        <translation>  线段 %1 淡化：φ %2，剩余 %3
</translation>
    </message>
    <message>
        <source>  segment %1 lifts: φ %2, share %3
</source>
        <translation>  线段 %1 吸走：φ %2，占比 %3
</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, is missing or of another version, so texts are left out; install Suffuse again, with what suffuse-cli recommends</source>
        <translation>Suffuse 的一部分 %1 缺失或属于其他版本，因此文字被略去；请重新安装 Suffuse，连同 suffuse-cli 推荐的软件包</translation>
    </message>
    <message>
        <source>  groups    %1</source>
        <translation>  组        %1</translation>
    </message>
    <message>
        <source>%1 of them blending</source>
        <translation>其中 %1 个自行混合</translation>
    </message>
    <message>
        <source>%1 clipped</source>
        <translation>%1 个被剪贴</translation>
    </message>
    <message>
        <source>%1 masking</source>
        <translation>%1 个作为蒙版</translation>
    </message>
    <message>
        <source>%1 a wash</source>
        <translation>%1 个淡彩</translation>
    </message>
    <message>
        <source>--transparent: the background is a layer of its own, which other programs can hide</source>
        <translation>--transparent：背景是单独的图层，其他程序可以将其隐藏</translation>
    </message>
    <message>
        <source>--depth %1: layers have 8 or 16 bits</source>
        <translation>--depth %1：图层为 8 或 16 位</translation>
    </message>
    <message>
        <source>--%1 is ignored: it is not for layered files</source>
        <translation>已忽略 --%1：不适用于带图层的文件</translation>
    </message>
    <message>
        <source>drawing layers</source>
        <translation>正在绘制图层</translation>
    </message>
    <message>
        <source>there is not enough memory for layers of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>内存不足以容纳 %1 × %2 像素的图层。请选择更小的尺寸。</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n 个组在其他程序中会显得不同；其图层改为显示它们对图片的效果</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 shown alone</source>
        <translation>%1 个单独显示</translation>
    </message>
    <message>
        <source>%1 a draft</source>
        <translation>%1 个草稿</translation>
    </message>
    <message>
        <source>  pictures  %1</source>
        <translation>  图片      %1</translation>
    </message>
    <message>
        <source>Draws groups that are drafts, too.</source>
        <translation>也绘制属于草稿的组。</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf</source>
        <translation>%1：未知的扩展名；请使用 .suffuse、.json、.svg、.svgz 或 .pdf</translation>
    </message>
    <message>
        <source>Converts between documents (.suffuse) and the text form (.json), and from pen recordings and drawings, and to drawings (.svg, .svgz, .pdf). What IN is, is found from its content; what OUT is, from its ending.</source>
        <translation>在文档（.suffuse）和文本形式（.json）之间转换，也可从笔迹记录和图形转换，并可转换为图形（.svg、.svgz、.pdf）。IN 的格式由内容判断，OUT 的格式由扩展名决定。</translation>
    </message>
    <message>
        <source>--format %1: give suffuse, json, svg or pdf</source>
        <translation>--format %1：请给出 suffuse、json、svg 或 pdf</translation>
    </message>
    <message>
        <source>Where OUT is -: suffuse, json, svg or pdf (default: json).</source>
        <translation>OUT 为 - 时：suffuse、json、svg 或 pdf（默认：json）。</translation>
    </message>
    <message>
        <source>--%1 is for drawings; give OUT the ending .svg or .pdf</source>
        <translation>--%1 用于图形；请让 OUT 的扩展名为 .svg 或 .pdf</translation>
    </message>
    <message>
        <source>--as %1: give outlines, bands or hybrid</source>
        <translation>--as %1：请给出 outlines、bands 或 hybrid</translation>
    </message>
    <message>
        <source>--bands %1: give a whole number from 1 to %2</source>
        <translation>--bands %1：请给出 1 到 %2 的整数</translation>
    </message>
    <message>
        <source>--bands is for --as bands; leave one of them out</source>
        <translation>--bands 用于 --as bands；请去掉其中之一</translation>
    </message>
    <message>
        <source>Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands (contours within each other, as opaque as the paint; the default) or hybrid (the exact picture under unpainted outlines).</source>
        <translation>OUT 为图形（.svg、.svgz、.pdf）时：outlines（每个笔画一条路径）、bands（层层嵌套的等值线，与颜料同样不透明；默认）或 hybrid（精确的图像，上面是不着色的轮廓）。</translation>
    </message>
    <message>
        <source>How many bands full opacity has, 1 to 256 (default: 16).</source>
        <translation>完全不透明分为多少条带，1 到 256（默认：16）。</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: all dried).</source>
        <translation>要绘制的时刻，以秒为单位（默认：全部干透）。</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>正在绘制</translation>
    </message>
    <message>
        <source>ICC profile of RGB colours that the file has (default: sRGB).</source>
        <translation>文件所用的 RGB 颜色 ICC 配置文件（默认：sRGB）。</translation>
    </message>
    <message>
        <source>--profile %1: %2; give an ICC profile of RGB colours</source>
        <translation>--profile %1：%2；请给出 RGB 颜色的 ICC 配置文件</translation>
    </message>
    <message>
        <source>Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, into which the sheet fits (default: the sheet as large as it is on paper; where that is not said, 96 units are an inch).</source>
        <translation>OUT 为 PDF 时：A3、A4、A5、Letter，或 200x150mm、8x6in 这样的尺寸，画纸会放入其中（默认：画纸在纸上的大小；没有给出时，96 个单位为一英寸）。</translation>
    </message>
    <message>
        <source>--page is for PDF; give OUT the ending .pdf</source>
        <translation>--page 用于 PDF；请让 OUT 的扩展名为 .pdf</translation>
    </message>
    <message>
        <source>--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in</source>
        <translation>--page %1：请给出 A3、A4、A5、Letter，或 200x150mm、8x6in 之类的尺寸</translation>
    </message>
    <message>
        <source>several INs become the pages of a PDF; give OUT the ending .pdf</source>
        <translation>多个 IN 会成为 PDF 的页面；请让 OUT 的扩展名为 .pdf</translation>
    </message>
    <message>
        <source>%1 is a picture: suffuse-cli render IN -o OUT writes pictures</source>
        <translation>%1 是图片：请用 suffuse-cli render IN -o OUT 来写图片</translation>
    </message>
    <message>
        <source>The painting to write: .suffuse or .json.</source>
        <translation>要写入的画作：.suffuse 或 .json。</translation>
    </message>
    <message>
        <source>At most so many strokes (default 512).</source>
        <translation>最多这么多笔画（默认 512）。</translation>
    </message>
    <message>
        <source>At most so many numbers, 27 for each stroke.</source>
        <translation>最多这么多数值，每个笔画 27 个。</translation>
    </message>
    <message>
        <source>As many strokes as this root mean square error needs, in 255ths.</source>
        <translation>达到此均方根误差（以 1/255 为单位）所需的笔画数。</translation>
    </message>
    <message>
        <source>So many paints, which become linked swatches.</source>
        <translation>这么多种颜料，它们会成为链接的色板。</translation>
    </message>
    <message>
        <source>feathering (default), uniform or edge.</source>
        <translation>feathering（默认）、uniform 或 edge。</translation>
    </message>
    <message>
        <source>No stroke is narrower, pixels of PICTURE.</source>
        <translation>笔画不会更窄，以 PICTURE 的像素计。</translation>
    </message>
    <message>
        <source>No stroke is wider, pixels of PICTURE.</source>
        <translation>笔画不会更宽，以 PICTURE 的像素计。</translation>
    </message>
    <message>
        <source>Another picture, white where PICTURE counts and black where not.</source>
        <translation>另一张图片：PICTURE 计入之处为白色，其余为黑色。</translation>
    </message>
    <message>
        <source>The share of the error as people see it, 0 (default) to 1.</source>
        <translation>按人眼所见计算的误差所占的比例，0（默认）到 1。</translation>
    </message>
    <message>
        <source>Goes on with a painting that was fitted before.</source>
        <translation>从以前拟合的画作继续。</translation>
    </message>
    <message>
        <source>How many steps (default 1200).</source>
        <translation>步数（默认 1200）。</translation>
    </message>
    <message>
        <source>PICTURE is averaged down to so many pixels (default 600000).</source>
        <translation>PICTURE 会被平均到这么多像素（默认 600000）。</translation>
    </message>
    <message>
        <source>Other numbers give other strokes (default 1).</source>
        <translation>不同的数字得到不同的笔画（默认 1）。</translation>
    </message>
    <message>
        <source>Prints how near the painting comes, as JSON (docs/cli.md).</source>
        <translation>以 JSON 输出画作的接近程度（docs/cli.md）。</translation>
    </message>
    <message>
        <source>--%1 %2: give a whole number from %3 to %4</source>
        <translation>--%1 %2：请给出 %3 到 %4 的整数</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to %4</source>
        <translation>--%1 %2：请给出 %3 到 %4 的数值</translation>
    </message>
    <message>
        <source>--style %1: give feathering, uniform or edge</source>
        <translation>--style %1：请给出 feathering、uniform 或 edge</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the painting to write</source>
        <translation>缺少 -o OUT：请指定要写入的画作</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse or .json</source>
        <translation>%1：未知的扩展名；请使用 .suffuse 或 .json</translation>
    </message>
    <message>
        <source>--strokes and --numbers say the same; give one of them</source>
        <translation>--strokes 与 --numbers 含义相同；请只给出其中一个</translation>
    </message>
    <message>
        <source>--style goes without --from, whose strokes have a style already</source>
        <translation>--style 不能与 --from 同用，其笔画已有样式</translation>
    </message>
    <message>
        <source>--greatest-width %1 is below --least-width %2</source>
        <translation>--greatest-width %1 小于 --least-width %2</translation>
    </message>
    <message>
        <source>%1: is a painting already; draw it with suffuse-cli render first</source>
        <translation>%1：已经是画作；请先用 suffuse-cli render 绘制</translation>
    </message>
    <message>
        <source>%1: there is no folder %2</source>
        <translation>%1：没有文件夹 %2</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1：无法写入</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>正在拟合</translation>
    </message>
    <message>
        <source>stopped; %1 has the strokes so far, and --from %1 goes on</source>
        <translation>已停止；%1 含有目前的笔画，可用 --from %1 继续</translation>
    </message>
    <message>
        <source>Makes strokes that look like a picture, from the back to the front and large before small.</source>
        <translation>生成看起来像图片的笔画，由后到前，先大后小。</translation>
    </message>
    <message>
        <source>there is not enough memory to fit %1. Choose fewer --pixels.</source>
        <translation>内存不足，无法拟合 %1。请选择较少的 --pixels。</translation>
    </message>
    <message>
        <source>make a painting of a picture</source>
        <translation>把图片变成画作</translation>
    </message>
    <message>
        <source>--strokes goes with --fit, which makes strokes of a picture</source>
        <translation>--strokes 要与 --fit 一起使用，后者把图片变成笔画</translation>
    </message>
    <message>
        <source>--%1 says nothing of a picture that is fitted; leave it out</source>
        <translation>--%1 与被拟合的图片无关；请去掉它</translation>
    </message>
    <message>
        <source>--fit takes one IN at a time</source>
        <translation>--fit 一次只接受一个 IN</translation>
    </message>
    <message>
        <source>Solves the diffusion curves of IN, or reads its picture, and makes strokes that look like it, as suffuse-cli fit does.</source>
        <translation>求解 IN 的扩散曲线或读取其图片，并像 suffuse-cli fit 那样生成外观相同的笔画。</translation>
    </message>
    <message>
        <source>With --fit: at most so many strokes (default 512).</source>
        <translation>与 --fit 一起：最多这么多笔画（默认 512）。</translation>
    </message>
    <message>
        <source>Also writes the picture that is fitted, as it was read, averaged or solved.</source>
        <translation>同时写出被拟合的图片，即读取、平均或求解后的样子。</translation>
    </message>
    <message>
        <source>--target %1: unknown ending; use one of %2</source>
        <translation>--target %1：未知的扩展名；请使用以下之一：%2</translation>
    </message>
    <message>
        <source>The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: standard input.</source>
        <translation>要读取的图片：PNG、JPEG、TIFF、EXR、WebP 或扩散曲线 (XML)；-：标准输入。</translation>
    </message>
    <message>
        <source>make fewer strokes that look like those of a painting</source>
        <translation>生成外观与画作相同但更少的笔画</translation>
    </message>
    <message>
        <source>The strokes to make anew, by their ids, such as 3,7,20-180 (default: all).</source>
        <translation>要重做的笔画的编号，例如 3,7,20-180（默认：全部）。</translation>
    </message>
    <message>
        <source>All strokes of the group of that name, in place of --select.</source>
        <translation>该名称的组的所有笔画，代替 --select。</translation>
    </message>
    <message>
        <source>A picture, or another painting, that the whole is to look like (default: as it does).</source>
        <translation>整体应当看起来像的图片或另一幅画（默认：保持现状）。</translation>
    </message>
    <message>
        <source>At most so many strokes (default: a quarter of those before).</source>
        <translation>最多这么多笔画（默认：原来的四分之一）。</translation>
    </message>
    <message>
        <source>What the strokes reach is fitted at so many pixels (default 600000).</source>
        <translation>笔画所及之处以这么多像素进行拟合（默认 600000）。</translation>
    </message>
    <message>
        <source>Says how near the painting comes as JSON (docs/cli.md).</source>
        <translation>以 JSON 说明画作接近的程度 (docs/cli.md)。</translation>
    </message>
    <message>
        <source>--select and --layer both say which strokes; give one of them</source>
        <translation>--select 和 --layer 都指定笔画；请只给出其中一个</translation>
    </message>
    <message>
        <source>--select %1: give ids of strokes, such as 3,7,20-180</source>
        <translation>--select %1：请给出笔画编号，例如 3,7,20-180</translation>
    </message>
    <message>
        <source>--select %1: there is no stroke %2; suffuse-cli convert IN OUT.json shows the ids</source>
        <translation>--select %1：没有笔画 %2；suffuse-cli convert IN OUT.json 会显示编号</translation>
    </message>
    <message>
        <source>--layer %1: several groups have that name; rename one of them</source>
        <translation>--layer %1：有多个组同名；请重命名其中一个</translation>
    </message>
    <message>
        <source>--layer %1: there is no group of that name</source>
        <translation>--layer %1：没有该名称的组</translation>
    </message>
    <message>
        <source>%1: is empty</source>
        <translation>%1：是空的</translation>
    </message>
    <message>
        <source>%1 strokes in place of %2. Where they are seen, the picture is %3 of 255 from what it should be (root mean square), %4 at most.</source>
        <translation>用 %1 条笔画代替 %2 条。在可见之处，画面与目标相差 %3/255（均方根），最多 %4。</translation>
    </message>
    <message>
        <source>Before it was %1, %2 at most.</source>
        <translation>之前是 %1，最多 %2。</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>原先夹在其间的 %n 条笔画现在位于下方。</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes fewer strokes that look like those of a painting, or makes them look like a picture, and says how near they come.</source>
        <translation>生成外观与画作相同但更少的笔画，或使它们看起来像一张图片，并说明接近的程度。</translation>
    </message>
    <message>
        <source>a small picture of a painting, for file managers</source>
        <translation>画作的缩略图，供文件管理器使用</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read.</source>
        <translation>要读取的画作、记录或图形。</translation>
    </message>
    <message>
        <source>The PNG file to write; -: standard output.</source>
        <translation>要写入的 PNG 文件；-：标准输出。</translation>
    </message>
    <message>
        <source>So many pixels a side at most, 1 to 1024.</source>
        <translation>每边最多的像素数，1 到 1024。</translation>
    </message>
    <message>
        <source>Writes a small picture of a painting as a PNG file: the preview in the file, if it has one. File managers call this.</source>
        <translation>把画作的小图写成 PNG 文件：若文件中有预览，就用预览。供文件管理器调用。</translation>
    </message>
    <message>
        <source>%1: give SIDE as a whole number of pixels from 1 to %2</source>
        <translation>%1：SIDE 应为 1 到 %2 的整数像素数</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are there</source>
        <translation>%2 份中已有 %1 份</translation>
    </message>
    <message>
        <source>%1: frames %2 are missing</source>
        <translation>%1：缺少第 %2 帧</translation>
    </message>
    <message>
        <source>%1: sheets %2 are missing</source>
        <translation>%1：缺少第 %2 张</translation>
    </message>
    <message>
        <source>%1: two workers made different bits of piece %2. One of the machines is faulty: find it by the names in %3, remove its journal there, and run the tasks again.</source>
        <translation>%1：两个工作进程对第 %2 份算出的比特不同。其中一台机器有故障：请按 %3 中的名称找出它，删除它在那里的日志，然后重新运行任务。</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>joining</source>
        <translation>正在合并</translation>
    </message>
    <message>
        <source>%1: sheet %2 cannot be read any more. Run the tasks again.</source>
        <translation>%1：第 %2 张已无法读取。请重新运行任务。</translation>
    </message>
    <message>
        <source>Says what is missing, by what workers wrote down.</source>
        <translation>根据工作进程的记录，说明缺少什么。</translation>
    </message>
    <message>
        <source>Says what is missing or damaged, by reading all of it.</source>
        <translation>读取全部内容，说明缺少或损坏了什么。</translation>
    </message>
    <message>
        <source>Puts the pictures together, once all is there and whole.</source>
        <translation>在全部齐备且完好后合并图像。</translation>
    </message>
    <message>
        <source>Nothing was joined. Run the tasks again: they draw what is missing.</source>
        <translation>没有合并任何内容。请重新运行任务：它们会绘制缺少的部分。</translation>
    </message>
    <message>
        <source>say what is to be drawn, in a shared folder</source>
        <translation>在共享文件夹中说明要绘制的内容</translation>
    </message>
    <message>
        <source>draw a part of it, on any machine</source>
        <translation>在任意机器上绘制其中一部分</translation>
    </message>
    <message>
        <source>what is missing</source>
        <translation>缺少什么</translation>
    </message>
    <message>
        <source>read all that is there, and compare the hashes</source>
        <translation>读取已有的全部内容并比较散列值</translation>
    </message>
    <message>
        <source>put the pictures together</source>
        <translation>合并图像</translation>
    </message>
    <message>
        <source>submit the work as a job array of Slurm</source>
        <translation>将工作作为 Slurm 作业数组提交</translation>
    </message>
    <message>
        <source>print the work as an Open Job Description</source>
        <translation>将工作输出为 Open Job Description</translation>
    </message>
    <message>
        <source>print the work as a job type of Flamenco</source>
        <translation>将工作输出为 Flamenco 的作业类型</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli farm COMMAND [options] …</source>
        <translation>用法：suffuse-cli farm 命令 [选项] …</translation>
    </message>
    <message>
        <source>farm %1: there is no such command. See suffuse-cli farm --help.</source>
        <translation>farm %1：没有此命令。请参阅 suffuse-cli farm --help。</translation>
    </message>
    <message>
        <source>Into how many tasks the work is divided (default: one for 64 pieces).</source>
        <translation>将工作分成多少个任务（默认每 64 份一个）。</translation>
    </message>
    <message>
        <source>--tasks %1: give a whole number, at least 1</source>
        <translation>--tasks %1：请给出不小于 1 的整数</translation>
    </message>
    <message>
        <source>sbatch cannot be started: install Slurm (slurm-client), or use --write-only</source>
        <translation>无法启动 sbatch：请安装 Slurm（slurm-client），或使用 --write-only</translation>
    </message>
    <message>
        <source>Submits the tasks as a job array, and the joining after it.</source>
        <translation>将任务作为作业数组提交，随后提交合并。</translation>
    </message>
    <message>
        <source>Cores of each task (default 2).</source>
        <translation>每个任务的核心数（默认 2）。</translation>
    </message>
    <message>
        <source>Writes the scripts, and submits nothing.</source>
        <translation>只写出脚本，不提交。</translation>
    </message>
    <message>
        <source>--cpus %1: give a whole number, at least 1</source>
        <translation>--cpus %1：请给出不小于 1 的整数</translation>
    </message>
    <message>
        <source>job %1: %2 tasks; job %3 joins what they draw</source>
        <translation>作业 %1：%2 个任务；作业 %3 合并它们绘制的内容</translation>
    </message>
    <message>
        <source>Prints a job template of the Open Job Description.</source>
        <translation>输出 Open Job Description 的作业模板。</translation>
    </message>
    <message>
        <source>Prints a job type of Flamenco 3 for its folder of scripts.</source>
        <translation>输出供 Flamenco 3 脚本文件夹使用的作业类型。</translation>
    </message>
    <message>
        <source>%1: the plan is damaged, or of another version; make it anew</source>
        <translation>%1：计划已损坏或版本不同；请重新制作</translation>
    </message>
    <message>
        <source>the plan is damaged; make it anew</source>
        <translation>计划已损坏；请重新制作</translation>
    </message>
    <message>
        <source>%1: there is another plan already. Remove the folder, or choose another one.</source>
        <translation>%1：已有另一份计划。请删除该文件夹，或选择另一个。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made. Choose another one, or change its permissions.</source>
        <translation>%1：无法创建文件夹。请选择另一个，或更改其权限。</translation>
    </message>
    <message>
        <source>%1: there is something else already. Remove it, or choose another name.</source>
        <translation>%1：已有其他内容。请将其删除，或选择另一个名称。</translation>
    </message>
    <message>
        <source>%1: there is no plan (%2). Is the shared folder there? farm plan makes one.</source>
        <translation>%1：没有计划（%2）。共享文件夹是否存在？farm plan 可制作计划。</translation>
    </message>
    <message>
        <source>%1: the folder is gone. Is the shared folder there?</source>
        <translation>%1：文件夹已消失。共享文件夹是否存在？</translation>
    </message>
    <message>
        <source>The folder of the farm, which all machines share.</source>
        <translation>渲染农场的文件夹，由所有机器共享。</translation>
    </message>
    <message>
        <source>Frames of the paintings being painted: name%05d.png; of several, %s is the painting&apos;s name.</source>
        <translation>绘画过程的帧：name%05d.png；有多幅画时，%s 是画的名称。</translation>
    </message>
    <message>
        <source>Tiles of a Deep Zoom: jpg or png.</source>
        <translation>Deep Zoom 的图块：jpg 或 png。</translation>
    </message>
    <message>
        <source>8 or 16 bits (default 8).</source>
        <translation>8 位或 16 位（默认 8）。</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100.</source>
        <translation>JPEG 和 WebP 的质量，1 到 100。</translation>
    </message>
    <message>
        <source>a farm draws numbered frames, name%05d.png</source>
        <translation>渲染农场绘制编号的帧，name%05d.png</translation>
    </message>
    <message>
        <source>Plans the drawing of paintings by many machines.</source>
        <translation>计划由多台机器绘制画作。</translation>
    </message>
    <message>
        <source>-o FOLDER is missing: name the folder that all machines share</source>
        <translation>缺少 -o 文件夹：请指定所有机器共享的文件夹</translation>
    </message>
    <message>
        <source>give --tiles or --frames</source>
        <translation>请给出 --tiles 或 --frames</translation>
    </message>
    <message>
        <source>several paintings need several names: put %s where the painting&apos;s name is to stand, as in out/%s.dzi</source>
        <translation>多幅画需要多个名称：请在画名的位置写 %s，例如 out/%s.dzi</translation>
    </message>
    <message>
        <source>%1: two paintings would become the same file. Rename one.</source>
        <translation>%1：两幅画会写入同一个文件。请重命名其中一幅。</translation>
    </message>
    <message>
        <source>--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8</source>
        <translation>--task %1：请给出 i/n，例如 3/8，从 1/8 到 8/8</translation>
    </message>
    <message>
        <source>the plan is for %1 &quot;%2&quot;, and this machine has &quot;%3&quot;, which makes other bits. Use the same program on all machines, or make a new plan</source>
        <translation>计划针对的 %1 是“%2”，而这台机器是“%3”，会得到不同的比特。请在所有机器上使用相同的程序，或制作新的计划</translation>
    </message>
    <message>
        <source>%1: the painting has changed since it was planned. Bring it back, or make a new plan.</source>
        <translation>%1：画作在计划之后已更改。请将其恢复，或制作新的计划。</translation>
    </message>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start the task again.</source>
        <translation>%1 其他后端绘制的比特不同，不会混入。请重新启动任务。</translation>
    </message>
    <message>
        <source>Draws what is missing of a task; as often as is liked.</source>
        <translation>绘制任务中缺少的部分；可以运行任意多次。</translation>
    </message>
    <message>
        <source>Which part: i/n, from 1/n to n/n (default 1/1).</source>
        <translation>哪一部分：i/n，从 1/n 到 n/n（默认 1/1）。</translation>
    </message>
    <message>
        <source>stopped; what is finished is kept, and the same command goes on</source>
        <translation>已停止；已完成的部分会保留，用同一命令即可继续</translation>
    </message>
    <message>
        <source>task %1: %2 drawn, %3 there already</source>
        <translation>任务 %1：绘制了 %2，已有 %3</translation>
    </message>
    <message>
        <source>let many machines draw pictures in tiles, and films</source>
        <translation>让多台机器绘制分块图像和影片</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a smaller --size, --scale or --area</source>
        <translation>%1 × %2 像素的图像太大：每边最多 %3。请选择更小的 --size、--scale 或 --area</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1：是文件夹。请给出文件名。</translation>
    </message>
    <message>
        <source>A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a folder; --format jpg or png.</source>
        <translation>任意大小的分块图像：OUT.dzi（Deep Zoom）、OUT.tif（BigTIFF）或文件夹；--format jpg 或 png。</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side (default 254; TIFF 512).</source>
        <translation>与 --tiles 一起：每边像素数（默认 254；TIFF 为 512）。</translation>
    </message>
    <message>
        <source>With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0).</source>
        <translation>与 --tiles 一起：图块显示相邻图块的像素数（默认 1；TIFF 为 0）。</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192).</source>
        <translation>与 --tiles 一起：一次绘制的每边像素数（默认 2048；CUDA 为 8192）。</translation>
    </message>
    <message>
        <source>--%1 is not for --tiles</source>
        <translation>--%1 不能与 --tiles 一起使用</translation>
    </message>
    <message>
        <source>--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder</source>
        <translation>--tiles %1：缺少名称：请给出 wall.dzi、wall.tif 或一个文件夹</translation>
    </message>
    <message>
        <source>--tiles %1: give a name that ends in .dzi or .tif, or a folder</source>
        <translation>--tiles %1：请给出以 .dzi 或 .tif 结尾的名称，或一个文件夹</translation>
    </message>
    <message>
        <source>--format is for Deep Zoom: the tiles of a TIFF are packed in it</source>
        <translation>--format 用于 Deep Zoom：TIFF 的图块压缩在文件之内</translation>
    </message>
    <message>
        <source>--format %1: tiles of a Deep Zoom are jpg or png</source>
        <translation>--format %1：Deep Zoom 的图块是 jpg 或 png</translation>
    </message>
    <message>
        <source>--depth %1: tiles have 8 or 16 bits</source>
        <translation>--depth %1：图块为 8 位或 16 位</translation>
    </message>
    <message>
        <source>tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif</source>
        <translation>JPEG 图块只有 8 位且不含透明度：请使用 --format png 或 .tif</translation>
    </message>
    <message>
        <source>tiles of a TIFF do not overlap, and have sides of a multiple of 16</source>
        <translation>TIFF 的图块不重叠，边长是 16 的倍数</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1：%n 幅画的 %2 份</numerusform>
        </translation>
    </message>
    <message>
        <source>these are more than %1 pieces. Choose a greater --sheet, a smaller picture, or several plans.</source>
        <translation>超过 %1 份。请选择更大的 --sheet、更小的图像，或多份计划。</translation>
    </message>
    <message>
        <source>other machines cannot read this standard input: give files</source>
        <translation>其他机器无法读取此标准输入：请给出文件</translation>
    </message>
    <message>
        <source>auto (default: a GPU where there is one), cpu or cuda.</source>
        <translation>auto（默认：有 GPU 就用 GPU）、cpu 或 cuda。</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu or cuda</source>
        <translation>--backend %1：请给出 auto、cpu 或 cuda</translation>
    </message>
    <message>
        <source>the GPU failed (%1); the CPU went on</source>
        <translation>GPU 出错（%1）；已由 CPU 继续</translation>
    </message>
    <message>
        <source>stopped before it came nearer than %1; nothing was written</source>
        <translation>在比 %1 更接近之前就停止了；没有写入任何内容</translation>
    </message>
    <message>
        <source>--error %1 was not reached: it is %2. Give more --strokes or --iterations.</source>
        <translation>--error %1 未达到：现为 %2。请增大 --strokes 或 --iterations。</translation>
    </message>
    <message>
        <source>%1: is damaged</source>
        <translation>%1：已损坏</translation>
    </message>
    <message>
        <source>%1: is missing</source>
        <translation>%1：缺失</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>另有 %n 个文件缺失或损坏；farm verify --json 会列出全部。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1：该日志有 %n 行已损坏，因此无法得知哪些已完成。请再次运行任务：它们会绘制缺失的部分。</numerusform>
        </translation>
    </message>
    <message>
        <source>the new strokes are farther from %1 than those before: %2 of 255, and before it was %3. Give more --strokes or --iterations.</source>
        <translation>新的笔画与 %1 的差距比原来更大：%2（共 255），原来是 %3。请增大 --strokes 或 --iterations。</translation>
    </message>
    <message>
        <source>%1 cannot be used</source>
        <translation>%1 无法使用</translation>
    </message>
    <message>
        <source>Lists the extensions that there are.</source>
        <translation>列出现有的扩展。</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1：无法读取</translation>
    </message>
    <message>
        <source>%1: there is no such extension. See suffuse-cli extension list.</source>
        <translation>%1：没有这样的扩展。请参阅 suffuse-cli extension list。</translation>
    </message>
    <message>
        <source>--set %1: give FIELD=VALUE with one of the fields %2</source>
        <translation>--set %1：请给出 FIELD=VALUE，字段为 %2 之一</translation>
    </message>
    <message>
        <source>%1; give it by --set</source>
        <translation>%1；请用 --set 给出</translation>
    </message>
    <message>
        <source>Runs an extension on a painting, and writes what it makes of it.</source>
        <translation>对画作运行扩展，并写出它生成的结果。</translation>
    </message>
    <message>
        <source>A field&apos;s value; may be given several times.</source>
        <translation>字段的值；可多次给出。</translation>
    </message>
    <message>
        <source>The strokes that are selected, by their ids, such as 3,7,20-180.</source>
        <translation>选中的笔画的编号，例如 3,7,20-180。</translation>
    </message>
    <message>
        <source>The group that is painted on, by its name.</source>
        <translation>正在绘制的组的名称。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the file to write</source>
        <translation>缺少 -o OUT：请指定要写入的文件</translation>
    </message>
    <message>
        <source>%1 makes no painting; leave -o away</source>
        <translation>%1 不生成画作；请去掉 -o</translation>
    </message>
    <message>
        <source>%1: end the name with .suffuse or .json</source>
        <translation>%1：文件名须以 .suffuse 或 .json 结尾</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli extension COMMAND [options] …</source>
        <translation>用法：suffuse-cli extension 命令 [选项] …</translation>
    </message>
    <message>
        <source>the extensions that there are, with their fields</source>
        <translation>现有的扩展及其字段</translation>
    </message>
    <message>
        <source>run one on a painting, and write what it makes of it</source>
        <translation>对画作运行一个扩展，并写出结果</translation>
    </message>
    <message>
        <source>extension %1: there is no such command. See suffuse-cli extension --help.</source>
        <translation>extension %1：没有这样的命令。请参阅 suffuse-cli extension --help。</translation>
    </message>
    <message>
        <source>run programs of others on a painting</source>
        <translation>对画作运行他人的程序</translation>
    </message>
    <message>
        <source>Its id, as extension list names it, or the path of its folder.</source>
        <translation>其标识（如 extension list 所列），或其文件夹的路径。</translation>
    </message>
    <message>
        <source>%1: it belongs to the farm in %2, and two farms would overwrite each other&apos;s pieces. Choose another name, or, if that farm is not wanted any more, remove its folder.</source>
        <translation>%1：属于 %2 中的渲染农场，两个渲染农场会互相覆盖对方的图块。请换一个名称；如果不再需要那个渲染农场，请删除其文件夹。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is another farm being planned?</source>
        <translation>%1：无法写入（%2）。是否正在规划另一个渲染农场？</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>剪贴板</translation>
    </message>
    <message>
        <source>There are no paths in the SVG of the clipboard.</source>
        <translation>剪贴板的 SVG 中没有路径。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>有 %Ln 个笔画离得太远，无法放在那里，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>供其他程序使用的 SVG 中不含柔和擦除的部分：%n 处擦除。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG 没有遮罩、擦除或剪贴下方内容的群组：%n 个群组已成为普通群组。</numerusform>
        </translation>
    </message>
    <message>
        <source>An erasure is not copied without the paint that it takes away. Duplicate doubles it within its stroke, Delete removes it.</source>
        <translation>擦除不能脱离它所去除的颜料单独复制。“再制”会在笔画内复制它，“删除”会移除它。</translation>
    </message>
    <message>
        <source>What was pasted lies outside of what is seen of the canvas. View ▸ Zoom to Selection goes there.</source>
        <translation>粘贴的内容位于画布可见部分之外。“视图 ▸ 缩放到所选内容”可前往该处。</translation>
    </message>
    <message>
        <source>There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.</source>
        <translation>在那里会看不到：粘贴的内容已放在画布可见部分的中央。</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG 没有淡彩：有 %n 个组的笔画在其中彼此叠放。</numerusform>
        </translation>
    </message>
    <message>
        <source>The clipboard holds no strokes, no SVG paths, no picture and no colour.</source>
        <translation>剪贴板中没有笔画、SVG 路径、图片或颜色。</translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>作为供其他程序使用的 SVG，图片被省略：%n 幅。</numerusform>
        </translation>
    </message>
    <message>
        <source>What came was painted after the moment that you look at. It was brought back to this moment, so that you see it.</source>
        <translation>新加入的笔画画在您正在看的时刻之后。它们已移到这一时刻，好让您看到。</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Delete segments</source>
        <translation>删除线段</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>已删除 %Ln 个线段；撤销可恢复。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1：%Ln 个笔画；撤销可恢复。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>已删除 %Ln 个笔画；撤销可恢复。</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>删除笔画</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>再制</translation>
    </message>
    <message>
        <source>The erasure is there twice now, and takes twice: drag the copy, or move it with the arrow keys.</source>
        <translation>擦除现在有两份，会去除两次：请拖动副本，或用方向键移动它。</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>上移一层</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>下移一层</translation>
    </message>
    <message>
        <source>Raise to top</source>
        <translation>移到顶层</translation>
    </message>
    <message>
        <source>Lower to bottom</source>
        <translation>移到底层</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>水平翻转</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>垂直翻转</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>旋转 90°</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>群组</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>解除群组</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>锁定笔画</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>隐藏笔画</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>全部解锁</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Rename strokes</source>
        <translation>重命名笔画</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>重命名组</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>简化</translation>
    </message>
    <message>
        <source>Smooth strokes</source>
        <translation>平滑笔画</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>拉直</translation>
    </message>
    <message>
        <source>Grow or shrink paint</source>
        <translation>增减颜料宽度</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>所选内容已锁定或隐藏。</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>没有变化。</translation>
    </message>
    <message>
        <source>Apply brush</source>
        <translation>应用画笔</translation>
    </message>
    <message>
        <source>Apply form of the brush</source>
        <translation>应用画笔的形态</translation>
    </message>
    <message>
        <source>Apply colour of the brush</source>
        <translation>应用画笔的颜色</translation>
    </message>
    <message>
        <source>Apply texture of the brush</source>
        <translation>应用画笔的质感</translation>
    </message>
    <message>
        <source>No appearance was copied.</source>
        <translation>尚未复制外观。</translation>
    </message>
    <message>
        <source>Paste appearance</source>
        <translation>粘贴外观</translation>
    </message>
    <message>
        <source>Combine strokes</source>
        <translation>合并笔画</translation>
    </message>
    <message>
        <source>Break apart</source>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Remove erasures</source>
        <translation>移除擦除</translation>
    </message>
    <message>
        <source>Recolour artwork</source>
        <translation>重新着色图稿</translation>
    </message>
    <message>
        <source>The painting has no swatches yet.</source>
        <translation>这幅画还没有色板。</translation>
    </message>
    <message>
        <source>Map colours to swatches</source>
        <translation>将颜色映射到色板</translation>
    </message>
    <message>
        <source>Not combined: one stroke has one fill, and these differ, overlap, or are missing in some strokes.</source>
        <translation>未合并：一条笔画只有一个填充，而所选笔画的填充各不相同、相互重叠，或有的没有填充。</translation>
    </message>
    <message>
        <source>Aligning takes two strokes or groups that are not locked. A group counts as one; it can be aligned relative to the canvas.</source>
        <translation>对齐需要两个未锁定的笔画或群组。一个群组算作一个，可相对于画布对齐。</translation>
    </message>
    <message>
        <source>Distributing takes three strokes or groups that are not locked. A group counts as one.</source>
        <translation>分布需要三个未锁定的笔画或群组。一个群组算作一个。</translation>
    </message>
    <message>
        <source>Clip group to what lies below</source>
        <translation>将组剪贴到下方</translation>
    </message>
    <message>
        <source>Clip group no more</source>
        <translation>不再剪贴组</translation>
    </message>
    <message>
        <source>Use group as mask</source>
        <translation>将组用作蒙版</translation>
    </message>
    <message>
        <source>Use group as mask no more</source>
        <translation>不再将组用作蒙版</translation>
    </message>
    <message>
        <source>Make group a wash</source>
        <translation>将组变为淡彩</translation>
    </message>
    <message>
        <source>Make wash a plain group</source>
        <translation>将淡彩变为普通组</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>删除图层</translation>
    </message>
    <message>
        <source>Make group a draft</source>
        <translation>将组设为草稿</translation>
    </message>
    <message>
        <source>Export draft again</source>
        <translation>重新导出草稿</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>现在是 %Ln 条笔画。颜料相接之处互相混合，不再叠加。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>已选择 %Ln 条笔画。再按一次删除键即可删除。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>已选择 %Ln 条线段。再按一次删除键即可删除。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>The selected strokes were exported last, and nothing is selected. Select strokes, or choose Export…</source>
        <translation>上次导出的是所选笔画，而现在没有选择。请选择笔画，或选择“导出…”</translation>
    </message>
    <message>
        <source>There is nothing to export. Choose Export…</source>
        <translation>没有可导出的内容。请选择“导出…”</translation>
    </message>
</context>
<context>
    <name>FigureWarnings</name>
    <message>
        <source>Widest at %1 s; from then on it grows narrower while it spreads.</source>
        <translation>在 %1 秒时最宽；此后一边扩散一边变窄。</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. Up to %1 is clear.</source>
        <translation>ξ2 相对于 ξ1 过大：笔画没有清晰的边缘，颜料所及之处都会染色。不超过 %1 时边缘清晰。</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the paint inside the dark rim vanishes.</source>
        <translation>ξ2 相对于 ξ1 过大：深色边缘以内的颜料会消失。</translation>
    </message>
    <message>
        <source>Density 0: there is no paint.</source>
        <translation>密度 0：没有颜料。</translation>
    </message>
    <message>
        <source>Opacity 0 %: nothing of it is seen.</source>
        <translation>不透明度 0 %：完全看不见。</translation>
    </message>
    <message>
        <source>Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.</source>
        <extracomment>%1: seconds after it was painted</extracomment>
        <translation>绘制 %1 秒后消褪：此后完全看不见。增大 φ，或减小 D 或干燥时间，可使其保留。</translation>
    </message>
    <message>
        <source>Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.</source>
        <translation>部分会消褪，最早在 %1 秒。增大 φ，或减小 D 或干燥时间，可使其保留。</translation>
    </message>
    <message>
        <source>Strength 0: nothing is taken away.</source>
        <translation>强度为 0：不会擦去任何颜料。</translation>
    </message>
</context>
<context>
    <name>FileReplacement</name>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1：无法写入（%2）。请选择其他文件夹，或更改其权限。</translation>
    </message>
    <message>
        <source>%1: the disk is full (%2). Free some space, or choose another disk.</source>
        <translation>%1：磁盘已满（%2）。请释放空间或选择其他磁盘。</translation>
    </message>
    <message>
        <source>%1: writing failed (%2). Choose another place.</source>
        <translation>%1：写入失败（%2）。请选择其他位置。</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1：是文件夹。请给出文件名。</translation>
    </message>
    <message>
        <source>%1: is not a plain file. Choose another name.</source>
        <translation>%1：不是普通文件。请选择其他名称。</translation>
    </message>
    <message>
        <source>%1: the folder %2 does not exist. Create it, or choose another.</source>
        <translation>%1：文件夹 %2 不存在。请创建它或选择其他文件夹。</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>a film has %1 to %2 frames a second</source>
        <translation>影片的帧率为每秒 %1 到 %2 帧</translation>
    </message>
    <message>
        <source>MP4 cannot hold transparency. Use WebM, WebP or frames.</source>
        <translation>MP4 不支持透明度。请使用 WebM、WebP 或逐帧图片。</translation>
    </message>
    <message>
        <source>a video has at most %1 pixels a side</source>
        <translation>视频每边最多 %1 像素</translation>
    </message>
    <message>
        <source>%1: cannot write into this folder. Choose another one.</source>
        <translation>%1：无法写入此文件夹。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>frames are numbered files: give a name such as film/%05d.png, or one that ends in .webp, .webm or .mp4</source>
        <translation>各帧是带编号的文件：请给出类似 film/%05d.png 的名称，或以 .webp、.webm、.mp4 结尾的名称</translation>
    </message>
    <message>
        <source>%1: ffmpeg, which makes videos, is not installed. Install it, or choose WebP or frames.</source>
        <translation>%1：未安装生成视频所需的 ffmpeg。请安装它，或选择 WebP 或逐帧图片。</translation>
    </message>
    <message>
        <source>%1: ffmpeg could not make the video (%2). Choose another format or size.</source>
        <translation>%1：ffmpeg 未能生成视频（%2）。请选择其他格式或尺寸。</translation>
    </message>
    <message>
        <source>%1: the film could not be written (%2).</source>
        <translation>%1：未能写入影片（%2）。</translation>
    </message>
    <message>
        <source>%1: the film is too large for WebP. Choose another format, a smaller size or fewer frames.</source>
        <translation>%1：影片对 WebP 而言太大。请选择其他格式、较小的尺寸或较少的帧数。</translation>
    </message>
</context>
<context>
    <name>ImageFormat</name>
    <message>
        <source>This is no image format that can be written. Use one of these endings: %1.</source>
        <translation>这不是可写入的图像格式。请使用以下扩展名之一：%1。</translation>
    </message>
    <message>
        <source>%1 cannot hold depth %2. Choose %3, or another format.</source>
        <translation>%1 不支持位深 %2。请选择 %3 或其他格式。</translation>
    </message>
    <message>
        <source>%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.</source>
        <translation>%1 不支持透明度。请使用 PNG、TIFF、EXR 或 WebP，或连同背景一起导出。</translation>
    </message>
    <message>
        <source>%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.</source>
        <translation>%1 每边支持 1 到 %2 像素，而不是 %3 × %4。请选择其他尺寸或格式。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large: at most %3 million pixels can be drawn. Choose a smaller size.</source>
        <translation>%1 × %2 像素的图片过大：最多可绘制 %3 百万像素。请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.</source>
        <translation>%1 不能包含颜色配置文件。请用 PNG、TIFF、JPEG 或 WebP，或以 sRGB 导出。</translation>
    </message>
</context>
<context>
    <name>ImageModule</name>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>无法加载（%1）</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>属于另一版本的 Suffuse</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again, with what suffuse-cli recommends. Pictures ending in .pfm work without it</source>
        <translation>Suffuse 的组件 %1 %2；请重新安装 Suffuse，连同 suffuse-cli 推荐的软件包。以 .pfm 结尾的图片无需它</translation>
    </message>
</context>
<context>
    <name>ImageReader</name>
    <message>
        <source>%1: the image declares more than %2 × %2 or %3 million pixels. Scale it down first.</source>
        <translation>%1：图像声明的尺寸超过 %2 × %2 或 %3 百万像素。请先缩小。</translation>
    </message>
    <message>
        <source>%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.</source>
        <translation>%1：不是 PNG、JPEG、TIFF、EXR 或 WebP 图像。请转换为其中之一。</translation>
    </message>
    <message>
        <source>%1: cannot read %2: %3.</source>
        <translation>%1：无法读取 %2：%3。</translation>
    </message>
    <message>
        <source>%1: the %2 image cannot be read (%3). It may be damaged, or too large (at most %4 pixels a side, %5 million in all).</source>
        <translation>%1：无法读取 %2 图像（%3）。它可能已损坏或过大（每边最多 %4 像素，总计 %5 百万）。</translation>
    </message>
</context>
<context>
    <name>ImageWriter</name>
    <message>
        <source>%1: cannot write %2: %3.</source>
        <translation>%1：无法写入 %2：%3。</translation>
    </message>
    <message>
        <source>%1: writing was cancelled; nothing was changed.</source>
        <translation>%1：写入已取消；未做任何更改。</translation>
    </message>
    <message>
        <source>%1: %2 could not be written (%3). Choose another format or depth.</source>
        <translation>%1：未能写入 %2（%3）。请选择其他格式或位深。</translation>
    </message>
    <message>
        <source>%1: the colour profile cannot be used: %2. Choose another one.</source>
        <translation>%1：无法使用该颜色配置文件：%2。请选择另一个。</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>there are no strokes in it</source>
        <translation>其中没有笔画</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>导入笔画</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Return</source>
        <extracomment>the key, as it is called on keyboards</extracomment>
        <translation>回车</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Save the changes to “%1” before closing?</source>
        <translation>关闭前要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>Suffuse did not come up the last times, so it has started with the usual settings. Yours are kept in %1.</source>
        <translation>前几次 Suffuse 未能启动，因此本次使用默认设置启动。您的设置保存在 %1。</translation>
    </message>
    <message>
        <source>Leave out the quotation marks: file dialogs take them for the borders between several names.</source>
        <translation>请去掉引号：文件对话框会把引号当作多个名称之间的分隔。</translation>
    </message>
    <message>
        <source>“%1” is only an ending. Give a name before it.</source>
        <translation>“%1”只是扩展名，请在前面加上名称。</translation>
    </message>
    <message>
        <source>Nothing is lost: the painting stays open as it is.</source>
        <translation>没有丢失任何内容：画作保持打开，一切照旧。</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>另一个程序更改了“%1”。</translation>
    </message>
    <message>
        <source>The file stays as it is until you save.</source>
        <translation>在您保存之前，文件保持原样。</translation>
    </message>
    <message>
        <source>Overwriting gives up what the other program wrote.</source>
        <translation>覆盖会放弃另一个程序写入的内容。</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>覆盖(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keep Mine</source>
        <translation>保留我的(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>重新载入(&amp;R)</translation>
    </message>
    <message>
        <source>Reloading takes away what was painted since the last save; Undo brings it back.</source>
        <translation>重新载入会去掉上次保存以来绘制的内容；撤销可将其恢复。</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>“%1”已存在。要替换吗？</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>Without saving, what has not been saved yet is lost.</source>
        <translation>若不保存，尚未保存的内容将会丢失。</translation>
    </message>
</context>
<context>
    <name>NodeDrag</name>
    <message>
        <source>Move nodes</source>
        <translation>移动节点</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>移动节点</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>移动控制柄</translation>
    </message>
    <message>
        <source>Bend curve</source>
        <translation>弯曲曲线</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>移动擦除</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>paper image</source>
        <translation>纸张图像</translation>
    </message>
    <message>
        <source>paper image: there is none. Choose an image, or another kind of paper.</source>
        <translation>纸张图像：没有图像。请选择图像或另一种纸张。</translation>
    </message>
</context>
<context>
    <name>Papers</name>
    <message>
        <source>Smooth</source>
        <translation>光滑</translation>
    </message>
    <message>
        <source>Cold press</source>
        <translation>冷压</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>粗纹</translation>
    </message>
    <message>
        <source>Rice</source>
        <translation>宣纸</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>油画布</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MB: choose a smaller picture.</source>
        <translation>%1 大于 64 MB：请选择较小的图片。</translation>
    </message>
</context>
<context>
    <name>ReferenceRenderer</name>
    <message>
        <source>%1 threads · double</source>
        <translation>%1 个线程 · 双精度</translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n 个线程</numerusform>
        </translation>
    </message>
    <message>
        <source>The CUDA backend cannot run: %1. Use the CPU backend.</source>
        <translation>CUDA 后端无法运行：%1。请使用 CPU 后端。</translation>
    </message>
    <message>
        <source>%1 stopped: %2. The CPU draws now.</source>
        <translation>%1 已停止：%2。现由 CPU 绘制。</translation>
    </message>
    <message>
        <source>the picture is too large</source>
        <translation>图像过大</translation>
    </message>
    <message>
        <source>this program was built without the CUDA renderer</source>
        <translation>此程序构建时未包含 CUDA 渲染器</translation>
    </message>
    <message>
        <source>no NVIDIA driver, or one that is too old for this program</source>
        <translation>没有 NVIDIA 驱动程序，或其版本对本程序而言过旧</translation>
    </message>
    <message>
        <source>there is no NVIDIA GPU</source>
        <translation>没有 NVIDIA GPU</translation>
    </message>
    <message>
        <source>the NVIDIA driver does not work</source>
        <translation>NVIDIA 驱动程序无法工作</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>内存不足以容纳 %1 × %2 像素。请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>The reference finds no gradients. Use the CPU backend.</source>
        <translation>参考实现不求梯度。请使用 CPU 后端。</translation>
    </message>
</context>
<context>
    <name>Retiming</name>
    <message>
        <source>Ease in time</source>
        <translation>时间缓动</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>在时间上移动</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>在时间上伸缩</translation>
    </message>
    <message>
        <source>%1, with its erasures</source>
        <translation>%1，擦除随之移动</translation>
    </message>
    <message>
        <source>%1; erasures keep their time</source>
        <translation>%1；擦除的时间不变</translation>
    </message>
    <message>
        <source>Later by %1 s</source>
        <translation>移动 %1 秒</translation>
    </message>
    <message>
        <source>Drawn in %1 s</source>
        <translation>绘制用时 %1 秒</translation>
    </message>
    <message>
        <source>Begins at %1 % of its pace</source>
        <translation>以其速度的 %1 % 开始</translation>
    </message>
    <message>
        <source>Ends at %1 % of its pace</source>
        <translation>以其速度的 %1 % 结束</translation>
    </message>
</context>
<context>
    <name>SelectHints</name>
    <message>
        <source>Drag: scale. Ctrl: keep the proportions. Shift: about the centre.</source>
        <translation>拖动：缩放。Ctrl：保持比例。Shift：以中心为基准。</translation>
    </message>
    <message>
        <source>Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.</source>
        <translation>拖动：旋转。Ctrl：以 15° 为步长。Shift：绕对角旋转。</translation>
    </message>
    <message>
        <source>Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.</source>
        <translation>拖动：倾斜。Ctrl：以 15° 为步长。Shift：以对边为基准。</translation>
    </message>
    <message>
        <source>Drag: move the centre of rotation. Shift+click: back into the middle.</source>
        <translation>拖动：移动旋转中心。Shift+点击：恢复到正中。</translation>
    </message>
    <message>
        <source>Shift+Alt+click: add the next stroke below, with Ctrl within its group. Shift+Alt+drag: add what the path touches.</source>
        <translation>Shift+Alt+点击：添加下方的下一条笔画，按住 Ctrl 时为组内的笔画。Shift+Alt+拖动：添加路径触碰到的内容。</translation>
    </message>
    <message>
        <source>Alt+click: select the next stroke below, with Ctrl within its group. Alt+drag: select what the path touches.</source>
        <translation>Alt+点击：选择下方的下一条笔画，按住 Ctrl 时为组内的笔画。Alt+拖动：选择路径触碰到的内容。</translation>
    </message>
    <message>
        <source>Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.</source>
        <translation>Ctrl+Shift+点击：添加或移除组中的单条笔画。Ctrl+Shift+拖动：移除。</translation>
    </message>
    <message>
        <source>Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.</source>
        <translation>Ctrl+点击：选择组中的单条笔画。Ctrl+拖动：沿坐标轴移动。</translation>
    </message>
    <message>
        <source>Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.</source>
        <translation>Shift+点击：添加或移除。Shift+拖动：添加选框圈住的内容；移动时：不吸附。</translation>
    </message>
    <message>
        <source>Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke below.</source>
        <translation>点击颜料选择其笔画。拖动：框选，在颜料上按住 Shift。Alt+点击：下层笔画。</translation>
    </message>
    <message>
        <source>Move by %1, %2</source>
        <translation>移动 %1, %2</translation>
    </message>
    <message>
        <source>Scale to %1 % × %2 %</source>
        <translation>缩放到 %1 % × %2 %</translation>
    </message>
    <message>
        <source>Rotate by %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>Skew by %1°</source>
        <translation>倾斜 %1°</translation>
    </message>
    <message>
        <source>Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one below.</source>
        <translation>拖动：移动。再次点击：旋转和倾斜。双击：数值。Shift+点击：添加。Alt+点击：下层笔画。</translation>
    </message>
</context>
<context>
    <name>SvgPaths</name>
    <message>
        <source>SVG, line %1: %2</source>
        <translation>SVG 第 %1 行：%2</translation>
    </message>
</context>
<context>
    <name>TimelinePicture</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Each stroke is a bar here: from when it is painted until it is dry.</source>
        <translation>此处每条笔画为一个横条：从绘制开始到干透为止。</translation>
    </message>
</context>
<context>
    <name>Underlay</name>
    <message>
        <source>%1: there is not enough memory for it.</source>
        <translation>%1：内存不足。</translation>
    </message>
</context>
<context>
    <name>UnderlayCommands</name>
    <message>
        <source>Import underlay</source>
        <translation>导入底图</translation>
    </message>
    <message>
        <source>Replace underlay</source>
        <translation>替换底图</translation>
    </message>
    <message>
        <source>Show underlay</source>
        <translation>显示底图</translation>
    </message>
    <message>
        <source>Hide underlay</source>
        <translation>隐藏底图</translation>
    </message>
    <message>
        <source>Change underlay opacity</source>
        <translation>更改底图不透明度</translation>
    </message>
    <message>
        <source>Move underlay</source>
        <translation>移动底图</translation>
    </message>
    <message>
        <source>Resize underlay</source>
        <translation>调整底图大小</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>底图</translation>
    </message>
    <message>
        <source>Fit underlay to the canvas</source>
        <translation>底图适合画布</translation>
    </message>
    <message>
        <source>Remove underlay</source>
        <translation>移除底图</translation>
    </message>
</context>
<context>
    <name>Validate</name>
    <message>
        <source>it is earlier than the one before it; put them in order of time</source>
        <translation>它早于前一个；请按时间顺序排列</translation>
    </message>
    <message>
        <source>another group has the same id</source>
        <translation>另一个组有相同的 id</translation>
    </message>
    <message>
        <source>there is no group with this id</source>
        <translation>没有此 id 的组</translation>
    </message>
    <message>
        <source>the group would lie within itself</source>
        <translation>组将包含其自身</translation>
    </message>
    <message>
        <source>the group&apos;s members do not stand together in the order</source>
        <translation>组的成员在顺序中不相邻</translation>
    </message>
    <message>
        <source>there is no such style</source>
        <translation>没有此样式</translation>
    </message>
    <message>
        <source>only edge darkening has a third value</source>
        <translation>只有深色边缘有第三个值</translation>
    </message>
    <message>
        <source>there is no such mixing mode</source>
        <translation>没有此混合模式</translation>
    </message>
    <message>
        <source>only beta mixing has a beta</source>
        <translation>只有 beta 混合有 beta 值</translation>
    </message>
    <message>
        <source>there is no such kind of node</source>
        <translation>没有此类型的节点</translation>
    </message>
    <message>
        <source>a stroke needs at least one</source>
        <translation>一条笔画至少需要一条</translation>
    </message>
    <message>
        <source>a segment that lifts cannot fade as well</source>
        <translation>柔擦的线段不能同时淡化</translation>
    </message>
    <message>
        <source>the segment does not start where the one before it ends</source>
        <translation>线段的起点不在前一段的终点</translation>
    </message>
    <message>
        <source>there is no such kind of paper</source>
        <translation>没有此类型的纸张</translation>
    </message>
    <message>
        <source>the paper&apos;s image is missing</source>
        <translation>缺少纸张图像</translation>
    </message>
    <message>
        <source>the stroke is missing</source>
        <translation>缺少笔画</translation>
    </message>
    <message>
        <source>another stroke has the same id</source>
        <translation>另一条笔画有相同的 id</translation>
    </message>
    <message>
        <source>%1: %2 is not in %3</source>
        <translation>%1：%2 不在 %3 内</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>没有此类型</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input</source>
        <translation>另一条曲线有相同的参数和输入</translation>
    </message>
    <message>
        <source>it needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>需要 2 到 16 个位于 [0, 1] 内的点 [x, y]，从左到右</translation>
    </message>
    <message>
        <source>there is no such rule</source>
        <translation>没有这样的规则</translation>
    </message>
    <message>
        <source>it is the same point as from; a gradient needs two</source>
        <translation>与 from 是同一点；渐变需要两个点</translation>
    </message>
    <message>
        <source>there is no such grain of paper</source>
        <translation>没有此纸张颗粒</translation>
    </message>
    <message>
        <source>style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2</source>
        <translation>style.xi[1]：%1 大于 xi[0] 的 2^(1/3) 倍，而 xi[0] 为 %2</translation>
    </message>
    <message>
        <source>there is no such alignment</source>
        <translation>没有此对齐方式</translation>
    </message>
    <message>
        <source>it is no valid Unicode</source>
        <translation>这不是有效的 Unicode</translation>
    </message>
    <message>
        <source>%1: %2 characters are more than %3</source>
        <translation>%1：%2 个字符超过了 %3 个</translation>
    </message>
    <message>
        <source>%1: %2 curves are more than %3</source>
        <translation>%1：%2 条曲线超过了 %3 条</translation>
    </message>
    <message>
        <source>there is no such blend mode</source>
        <translation>没有这种混合模式</translation>
    </message>
    <message>
        <source>there is no such colour to mark groups</source>
        <translation>没有这种分组标记颜色</translation>
    </message>
    <message>
        <source>it needs an image, or a link with the SHA-256 of its file</source>
        <translation>需要一幅图像，或者带有文件 SHA-256 的链接</translation>
    </message>
    <message>
        <source>it is no path of a file</source>
        <translation>不是文件路径</translation>
    </message>
    <message>
        <source>it has more than 67 million pixels</source>
        <translation>超过 6700 万像素</translation>
    </message>
    <message>
        <source>its corners lie on one line; a picture needs an area</source>
        <translation>它的角在一条直线上；图片需要有面积</translation>
    </message>
</context>
<context>
    <name>WidthHandle</name>
    <message>
        <source>Drag to set the width by the density, Shift: by the diffusion.</source>
        <translation>拖动以通过密度设置宽度，Shift：通过扩散系数设置。</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>更改宽度</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.</source>
        <translation>图片尺寸不同（%1 × %2 与 %3 × %4）：请以相同尺寸渲染。</translation>
    </message>
</context>
<context>
    <name>suffuse::AboutDialog</name>
    <message>
        <source>About Suffuse</source>
        <translation>关于 Suffuse</translation>
    </message>
    <message>
        <source>Icon of Suffuse</source>
        <translation>Suffuse 图标</translation>
    </message>
    <message>
        <source>Suffuse %1</source>
        <translation>Suffuse %1</translation>
    </message>
    <message>
        <source>Paints with strokes that really diffuse, and stay editable.</source>
        <translation>用真正会扩散、且始终可编辑的笔画作画。</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0.</source>
        <translation>基于 Apache 许可证 2.0 的自由软件。</translation>
    </message>
</context>
<context>
    <name>suffuse::AgePlot</name>
    <message>
        <source>No paint here</source>
        <translation>此处没有颜料</translation>
    </message>
    <message>
        <source>density φ, up to %1</source>
        <translation>密度 φ，最高 %1</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 秒</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>落笔后 %1 秒</translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message>
        <source>Along the Stroke</source>
        <translation>沿笔画变化</translation>
    </message>
    <message>
        <source>Curve along the stroke</source>
        <translation>沿笔画的曲线</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>恒定</translation>
    </message>
    <message>
        <source>The same value all along</source>
        <translation>全程相同的值</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>Evenly from one value to another</source>
        <translation>从一个值均匀变化到另一个值</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>手绘</translation>
    </message>
    <message>
        <source>A curve drawn with the pointer</source>
        <translation>用指针绘制的曲线</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>End</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Change along the stroke</source>
        <translation>更改沿笔画的变化</translation>
    </message>
    <message>
        <source>Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve is drawn with the pointer. The dots are the values of the segments.</source>
        <translation>拖动线条、其两端或控制点；在旁边按下可添加点，Del 可删除点。手绘曲线用指针绘制。小圆点为各线段的值。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>The values that there are, as a curve of points that can be moved</source>
        <translation>以可移动的控制点曲线显示现有的值</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>增减</translation>
    </message>
    <message>
        <source>Multiplies all of it; what varies along the stroke stays</source>
        <translation>整体相乘；沿笔画的变化保持不变</translation>
    </message>
    <message>
        <source>Is added to all of it; what varies along the stroke stays</source>
        <translation>整体增减；沿笔画的变化保持不变</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n 个笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke – %1</source>
        <translation>沿笔画变化 – %1</translation>
    </message>
    <message>
        <source>Nothing is selected that can be changed. Click a stroke, and its values are shown here.</source>
        <translation>没有选中可以更改的内容。点击一个笔画，这里就会显示它的值。</translation>
    </message>
</context>
<context>
    <name>suffuse::AreaRow</name>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Which part of the canvas is drawn</source>
        <translation>绘制画布的哪一部分</translation>
    </message>
    <message>
        <source>Whole canvas</source>
        <translation>整个画布</translation>
    </message>
    <message>
        <source>What is painted</source>
        <translation>已绘制的内容</translation>
    </message>
    <message>
        <source>Selected strokes</source>
        <translation>所选笔画</translation>
    </message>
    <message>
        <source>What the window shows</source>
        <translation>窗口所示部分</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>按数值</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>左边缘</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>上边缘</translation>
    </message>
    <message>
        <source>W</source>
        <translation>宽</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>H</source>
        <translation>高</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantRow</name>
    <message>
        <source>Parallel Lines</source>
        <translation>平行线</translation>
    </message>
    <message>
        <source>Vanishing Point</source>
        <translation>灭点</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Concentric Ellipses</source>
        <translation>同心椭圆</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>直尺</translation>
    </message>
    <message>
        <source>What is made next</source>
        <translation>接下来创建的类型</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Horizontal place of the chosen point, canvas units</source>
        <translation>所选点的水平位置，画布单位</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Vertical place of the chosen point, canvas units</source>
        <translation>所选点的垂直位置，画布单位</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Angle of the line or of the first half axis, clockwise</source>
        <translation>直线或第一半轴的角度，顺时针</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>First half axis of the ellipse, canvas units</source>
        <translation>椭圆的第一半轴，画布单位</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Second half axis of the ellipse, canvas units</source>
        <translation>椭圆的第二半轴，画布单位</translation>
    </message>
    <message>
        <source>A new one in the middle of the view</source>
        <translation>在视图中央新建一个</translation>
    </message>
    <message>
        <source>New assistant</source>
        <translation>新建辅助尺</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantTool</name>
    <message>
        <source>Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next point. Return: a new one.</source>
        <translation>拖动新建辅助尺；拖动其点或线来修改。Shift：分步。Tab：下一点。回车：新建一个。</translation>
    </message>
    <message>
        <source>%1, point %2 of %3: x %4, y %5</source>
        <extracomment>%1: an assistant, as &quot;Vanishing Point&quot;</extracomment>
        <translation>%1，点 %2/%3：x %4，y %5</translation>
    </message>
</context>
<context>
    <name>suffuse::AttributeBrushTool</name>
    <message>
        <source>How fast it is laid down</source>
        <translation>施加的快慢</translation>
    </message>
    <message>
        <source>Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.</source>
        <translation>在笔画上拖动，将选定的值绘制到其线段上。[ 和 ] 更改大小。</translation>
    </message>
    <message>
        <source>Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.</source>
        <translation>在所选内容上拖动，将选定的值绘制到其线段上。[ 和 ] 更改大小。</translation>
    </message>
    <message>
        <source>Paint diffusion</source>
        <translation>绘制扩散系数</translation>
    </message>
    <message>
        <source>Paint density</source>
        <translation>绘制密度</translation>
    </message>
    <message>
        <source>Paint granulation</source>
        <translation>绘制颗粒</translation>
    </message>
    <message>
        <source>Paint colour</source>
        <translation>绘制颜色</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>绘制不透明度</translation>
    </message>
    <message>
        <source>Paint drying time</source>
        <translation>绘制干燥时间</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it is.</source>
        <translation>填充有自己的密度 ρ，可在检查器中查看。可以相对于现有值来绘制它。</translation>
    </message>
</context>
<context>
    <name>suffuse::BackupsDialog</name>
    <message>
        <source>Restore Backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings says how many are.</source>
        <translation>“%1”还没有备份。再次保存时会保留之前的版本；保留多少个可在设置中指定。</translation>
    </message>
    <message>
        <source>An earlier version of “%1” takes the place of the painting as it is now. Undo brings that back, and no file changes until you save.</source>
        <translation>“%1”的早先版本将取代当前的画作。撤销可恢复当前画作，保存之前不会改动任何文件。</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>备份，最新的在前</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>保存时间</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushColourPage</name>
    <message>
        <source>Second colour</source>
        <translation>第二颜色</translation>
    </message>
    <message>
        <source>&amp;Take the Current Colour</source>
        <translation>取当前颜色(&amp;T)</translation>
    </message>
    <message>
        <source>Makes the current colour the second one</source>
        <translation>将当前颜色设为第二颜色</translation>
    </message>
    <message>
        <source>The row Second colour of the curves says when it comes through.</source>
        <translation>何时显现由曲线中的“第二颜色”一行决定。</translation>
    </message>
    <message>
        <source>Strays from the colour by</source>
        <translation>颜色随机偏移量</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>At most so much redder or less red</source>
        <translation>红色最多增减此量</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>At most so much more or less yellow</source>
        <translation>黄色最多增减此量</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>At most so much bluer or less blue</source>
        <translation>蓝色最多增减此量</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>At most so much lighter or darker</source>
        <translation>明度最多增减此量</translation>
    </message>
    <message>
        <source>Drifts along the stroke</source>
        <translation>沿笔画漂移</translation>
    </message>
    <message>
        <source>Else each stroke has one colour</source>
        <translation>否则每条笔画只有一种颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCombo</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>搜索画笔</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCurvesPage</name>
    <message>
        <source>Second colour</source>
        <translation>第二颜色</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压感</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>By stroke</source>
        <translation>逐笔随机</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>What changes with what: a tick switches a curve on, a click shows it below</source>
        <translation>哪项参数随哪项输入变化：勾选以启用曲线，点击可在下方显示</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Drag points; click for another one, drag it out to take it away</source>
        <translation>拖动控制点；点击添加，拖出则移除</translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>Speed at the right end of its curves, in sizes a second</source>
        <translation>其曲线右端对应的速度，以每秒画笔大小的倍数计</translation>
    </message>
    <message>
        <source> sizes/s</source>
        <translation> 倍/秒</translation>
    </message>
    <message>
        <source>Full distance</source>
        <translation>最大距离</translation>
    </message>
    <message>
        <source>Distance at the right end of its curves, in sizes</source>
        <translation>其曲线右端对应的距离，以画笔大小的倍数计</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Way on which what drifts becomes another, in sizes</source>
        <translation>漂移的值变为另一个值所经过的路程，以画笔大小的倍数计</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushDialog</name>
    <message>
        <source>A stroke of the brush</source>
        <translation>画笔的示例笔画</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>颜料</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Shape and hand</source>
        <translation>形状与手感</translation>
    </message>
    <message>
        <source>Settings of the brush</source>
        <translation>画笔设置</translation>
    </message>
    <message>
        <source>Keeps the changes in the brush of this name; built-in brushes stay as they are</source>
        <translation>将更改保存到此名称的画笔；内置画笔保持不变</translation>
    </message>
    <message>
        <source>Keeps the brush under another name</source>
        <translation>以其他名称保存画笔</translation>
    </message>
    <message>
        <source>Closes this window; the brush stays in hand as it is</source>
        <translation>关闭此窗口；当前画笔保持现状</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>画笔：%1</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>保存更改(&amp;S)</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>另存为新画笔(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushGrid</name>
    <message>
        <source>Brushes</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>%1: size %2, dry after %3</source>
        <translation>%1：大小 %2，%3 后干</translation>
    </message>
    <message>
        <source>Changed since the program was started; Reload in its menu undoes that</source>
        <translation>启动程序后已更改；菜单中的“重新载入”可还原</translation>
    </message>
    <message>
        <source>There is no such brush.</source>
        <translation>没有这样的画笔。</translation>
    </message>
    <message>
        <source>Choose a brush to paint with it.</source>
        <translation>选择一支画笔来绘画。</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushHandPage</name>
    <message>
        <source>Tip</source>
        <translation>笔尖</translation>
    </message>
    <message>
        <source>Of the tip, against the path or the canvas</source>
        <translation>笔尖相对于路径或画布的角度</translation>
    </message>
    <message>
        <source>Turns with the path</source>
        <translation>随路径转动</translation>
    </message>
    <message>
        <source>Else it keeps its angle on the canvas, as a broad nib does</source>
        <translation>否则在画布上保持固定角度，如同宽头笔尖</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>两端</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Taper in</source>
        <translation>起笔渐粗</translation>
    </message>
    <message>
        <source>Length on which the stroke grows from its tip</source>
        <translation>笔画从笔锋逐渐变粗的长度</translation>
    </message>
    <message>
        <source>Taper out</source>
        <translation>收笔渐细</translation>
    </message>
    <message>
        <source>Length on which it runs out when the pen lifts</source>
        <translation>抬笔时笔画逐渐变细的长度</translation>
    </message>
    <message>
        <source>Tip size</source>
        <translation>末端大小</translation>
    </message>
    <message>
        <source>Size at the very end</source>
        <translation>最末端的大小</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手感</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>稳定手部抖动：笔画柔和地跟随笔，或像被绳子牵引</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>采样间隔</translation>
    </message>
    <message>
        <source>Time between the points that the curve is fitted through</source>
        <translation>拟合曲线所经各点之间的时间</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushLibrary</name>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; check its permissions</source>
        <translation>%1：未能创建文件夹；请检查其权限</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; save it under a name of its own</source>
        <translation>%1 是内置画笔；请以其他名称保存</translation>
    </message>
    <message>
        <source>A brush needs a name</source>
        <translation>画笔需要名称</translation>
    </message>
    <message>
        <source>There is a brush “%1” already</source>
        <translation>已有名为“%1”的画笔</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; it stays</source>
        <translation>%1 是内置画笔，不能删除</translation>
    </message>
    <message>
        <source>%1 could not be removed; check its permissions</source>
        <translation>未能删除 %1；请检查其权限</translation>
    </message>
    <message>
        <source>There is no brush “%1”</source>
        <translation>没有名为“%1”的画笔</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushMenu</name>
    <message>
        <source>&amp;Edit Brush…</source>
        <translation>编辑画笔(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>收藏(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>保存更改(&amp;S)</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>另存为新画笔(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>再制(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>De&amp;lete…</source>
        <translation>删除(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Save Brush</source>
        <translation>保存画笔</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Rename Brush</source>
        <translation>重命名画笔</translation>
    </message>
    <message>
        <source>Delete the brush “%1”?</source>
        <translation>要删除画笔“%1”吗？</translation>
    </message>
    <message>
        <source>Strokes painted with it stay.</source>
        <translation>用它绘制的笔画会保留。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Import Brushes</source>
        <translation>导入画笔</translation>
    </message>
    <message>
        <source>Brushes (*.suffuse-brush *.myb);;All files (*)</source>
        <translation>画笔 (*.suffuse-brush *.myb);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1: these settings have no counterpart here: %2</source>
        <translation>%1：以下设置在此没有对应项：%2</translation>
    </message>
    <message>
        <source>Export Brush</source>
        <translation>导出画笔</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse 画笔</translation>
    </message>
    <message>
        <source>Rel&amp;oad</source>
        <translation>重新载入(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Apply to Selection</source>
        <translation>应用于所选(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>整个画笔(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>仅形态(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>仅颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>仅质感(&amp;T)</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPaintPage</name>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>密度如何转化为覆盖率。</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>颜料与下层的混合方式：覆盖，或颜料叠加。</translation>
    </message>
    <message>
        <source>How long the paint spreads; the size stays</source>
        <translation>颜料扩散多久；大小不变</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPalette</name>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>How large the painting is shown</source>
        <translation>画作显示得多大</translation>
    </message>
    <message>
        <source>Brush palette</source>
        <translation>画笔面板</translation>
    </message>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>选择用什么来画。颜色不变。</translation>
    </message>
    <message>
        <source>Current colour</source>
        <translation>当前颜色</translation>
    </message>
    <message>
        <source>Near colours</source>
        <translation>相近颜色</translation>
    </message>
    <message>
        <source>Lighter and darker, the neighbouring hues, and from grey to full</source>
        <translation>更亮与更暗、相邻的色相，以及从灰到饱和</translation>
    </message>
    <message>
        <source>Painted with last</source>
        <translation>最近用过</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>最近的颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPanel</name>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>选择作画所用的画笔，颜色保持不变。</translation>
    </message>
    <message>
        <source>Reset brush</source>
        <translation>重置画笔</translation>
    </message>
    <message>
        <source>Back to the brush as it came</source>
        <translation>恢复画笔的原始设置</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1（已修改）</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>搜索画笔</translation>
    </message>
    <message>
        <source>Shows brushes and groups with this in their name</source>
        <translation>显示名称包含此文本的画笔和组</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>仅收藏</translation>
    </message>
    <message>
        <source>Show favourites only; the first nine have the keys 1 to 9</source>
        <translation>仅显示收藏的画笔；前九个对应按键 1 到 9</translation>
    </message>
    <message>
        <source>Brush menu</source>
        <translation>画笔菜单</translation>
    </message>
    <message>
        <source>Edit, save, import and export brushes</source>
        <translation>编辑、保存、导入和导出画笔</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushTool</name>
    <message>
        <source>Brush stroke</source>
        <translation>画笔笔画</translation>
    </message>
    <message>
        <source>Shift+drag to go on with the selected stroke from its end.</source>
        <translation>Shift+拖动：从所选笔画的末端继续绘制。</translation>
    </message>
    <message>
        <source>Extend stroke</source>
        <translation>延长笔画</translation>
    </message>
    <message>
        <source>This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.</source>
        <translation>此笔画位于画布之外：视图 ▸ 显示画布外的颜料。</translation>
    </message>
    <message>
        <source>All that you paint stays editable: press V and click paint to move, scale or recolour it.</source>
        <translation>画下的一切都可以再编辑：按 V 并点击颜料，即可移动、缩放或重新上色。</translation>
    </message>
    <message>
        <source>Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture&apos;s colour, with Shift the stroke&apos;s own.</source>
        <translation>拖动绘制，轻点成点。右键：面板。Shift+拖动：大小和不透明度。Ctrl+点击：拾取画面颜色，再加 Shift：笔画本身的颜色。</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushToolOptions</name>
    <message>
        <source>Width of a dry line at full pressure, in units ([ and ] change it)</source>
        <translation>全压力下干燥线条的宽度，以单位计（[ 和 ] 可更改）</translation>
    </message>
    <message>
        <source>How much the paint covers ({ and } change it)</source>
        <translation>颜料的覆盖程度（{ 和 } 可更改）</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>稳定手部抖动：笔画柔和地跟随笔，或像被绳子牵引</translation>
    </message>
    <message>
        <source>Amount of smoothing</source>
        <translation>平滑程度</translation>
    </message>
    <message>
        <source>How strongly it lags behind, or how long the string is</source>
        <translation>滞后的强度，或绳子的长度</translation>
    </message>
    <message>
        <source>Own brush</source>
        <translation>自定义画笔</translation>
    </message>
    <message>
        <source>What to paint with. Click: all brushes, with pictures.</source>
        <translation>用什么来画。点击：所有画笔及其图样。</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasDrops</name>
    <message>
        <source>Drop colour</source>
        <translation>拖放颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasMenu</name>
    <message>
        <source>Under the Pointer</source>
        <translation>指针下方</translation>
    </message>
    <message>
        <source>Further Below</source>
        <translation>更下方</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>排列(&amp;R)</translation>
    </message>
    <message>
        <source>R&amp;eshape</source>
        <translation>整形(&amp;E)</translation>
    </message>
    <message>
        <source>Dr&amp;ying</source>
        <translation>干燥(&amp;Y)</translation>
    </message>
    <message>
        <source>Brush and C&amp;olours</source>
        <translation>画笔与颜色(&amp;O)</translation>
    </message>
    <message>
        <source>Apply &amp;Brush</source>
        <translation>应用画笔(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>节点(&amp;N)</translation>
    </message>
    <message>
        <source>Trans&amp;form</source>
        <translation>变换(&amp;F)</translation>
    </message>
    <message>
        <source>Com&amp;bine and Break</source>
        <translation>合并与拆分(&amp;B)</translation>
    </message>
    <message>
        <source>Select S&amp;ame</source>
        <translation>选择相同项(&amp;A)</translation>
    </message>
    <message>
        <source>Under&amp;lay</source>
        <translation>底图(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>颜色(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasSection</name>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Background colour. Click: white.</source>
        <translation>背景颜色。点击恢复白色。</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>更改背景</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>纸张</translation>
    </message>
    <message>
        <source>Resize canvas</source>
        <translation>调整画布大小</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>画布宽度（单位）；100 % 时 1 单位即 1 像素。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>画布高度（单位）；100 % 时 1 单位即 1 像素。</translation>
    </message>
    <message>
        <source>%1 × %2 mm at %3 dpi</source>
        <translation>%1 × %2 毫米，%3 dpi</translation>
    </message>
    <message>
        <source>%1 × %2 in at %3 dpi</source>
        <translation>%1 × %2 英寸，%3 dpi</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>图像…</translation>
    </message>
    <message>
        <source>The paper&apos;s grain, which granulating strokes show.</source>
        <translation>纸张的颗粒，会在有颗粒效果的笔画中显现。</translation>
    </message>
    <message>
        <source>Take the grain from another picture file.</source>
        <translation>从另一个图片文件获取颗粒。</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Another number gives another grain.</source>
        <translation>不同的数字产生不同的颗粒。</translation>
    </message>
    <message>
        <source>Change paper</source>
        <translation>更改纸张</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Paper image</source>
        <translation>纸张图像</translation>
    </message>
    <message>
        <source>%1 cannot be used as paper: %2</source>
        <translation>%1 不能用作纸张：%2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Size of the coarsest grain or of a thread in units, or units per pixel of the image.</source>
        <translation>最粗颗粒或织线的大小（单位），或图像每像素对应的单位数。</translation>
    </message>
    <message>
        <source>Choose &amp;Image…</source>
        <translation>选择图像(&amp;I)…</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasWidget</name>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>The picture goes to the screen by way of memory: %1</source>
        <translation>图像经由内存送到屏幕：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourChips</name>
    <message>
        <source>%1, opacity %2 %</source>
        <translation>%1，不透明度 %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourHeader</name>
    <message>
        <source>Shows and changes the colour that is painted with</source>
        <translation>显示并更改绘画所用的颜色</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>所选内容的颜色</translation>
    </message>
    <message>
        <source>Shows and changes the colour of what is selected; it keeps its opacity</source>
        <translation>显示并更改所选内容的颜色；不透明度保持不变</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设为</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Several colours</source>
        <translation>多种颜色</translation>
    </message>
    <message>
        <source>Set: all colours become the same.
Shift: all change as the shown one does, and keep their differences.</source>
        <translation>设为：所有颜色变得相同。
偏移：全部随所示颜色变化，并保持彼此的差异。</translation>
    </message>
    <message>
        <source>Apply to selection</source>
        <translation>应用到所选</translation>
    </message>
    <message>
        <source>Apply to selection: gives the selected segments the brush&apos;s colour. They keep their opacity.</source>
        <translation>应用到所选：将画笔的颜色赋予所选线段，不透明度保持不变。</translation>
    </message>
    <message>
        <source>Apply colour</source>
        <translation>应用颜色</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>画笔的颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPanel</name>
    <message>
        <source>Current colour</source>
        <translation>当前颜色</translation>
    </message>
    <message>
        <source>The colour that is painted with</source>
        <translation>正在使用的颜色</translation>
    </message>
    <message>
        <source>Previous colour</source>
        <translation>上一个颜色</translation>
    </message>
    <message>
        <source>The colour painted with last. Click: back to it.</source>
        <translation>上次作画用的颜色。点击返回该颜色。</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>十六进制</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB 颜色：#rrggbb、#rgb 或 CSS 写法，如 rgb(255, 0, 128)、hsl(20, 50%, 40%)、teal</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>“%1”不是颜色。请写成 #rrggbb，例如 #2f6690。</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>最近颜色</translation>
    </message>
    <message>
        <source>Colours painted with before. Click: take it.</source>
        <translation>先前用过的颜色。点击选用。</translation>
    </message>
    <message>
        <source>Colours painted with come here.</source>
        <translation>用过的颜色会显示在此处。</translation>
    </message>
    <message>
        <source>RYB</source>
        <extracomment>red, yellow, blue; hue, saturation, value; red, green, blue</extracomment>
        <translation>RYB</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>滑块</translation>
    </message>
    <message>
        <source>The numbers that the sliders show: paint as red, yellow and blue, or the screen&apos;s hue, saturation and value, or its red, green and blue</source>
        <translation>滑块显示的数值：颜料的红、黄、蓝，或屏幕的色相、饱和度、明度，或屏幕的红、绿、蓝</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>画笔的颜色</translation>
    </message>
    <message>
        <source>The colour of the brush. Click: take it.</source>
        <translation>画笔的颜色。点击：使用它。</translation>
    </message>
    <message>
        <source>several</source>
        <translation>多种</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message>
        <source>Colour of the brush</source>
        <translation>画笔的颜色</translation>
    </message>
    <message>
        <source>Colour of a swatch</source>
        <translation>色板的颜色</translation>
    </message>
    <message>
        <source>Colour of the swatch “%1”</source>
        <translation>色板“%1”的颜色</translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段的颜色（多种）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段的颜色</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画的颜色（多种）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画的颜色</numerusform>
        </translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>更改颜色</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>更改不透明度</translation>
    </message>
    <message>
        <source>Change swatch</source>
        <translation>更改色板</translation>
    </message>
    <message>
        <source>Colour of the fill</source>
        <translation>填充的颜色</translation>
    </message>
    <message>
        <source>Colours of the fill</source>
        <translation>填充的颜色</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s end</source>
        <translation>渐变终点的颜色</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s start</source>
        <translation>渐变起点的颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>色轮</translation>
    </message>
    <message>
        <source>Ring: hue in the order of pigments. Triangle: pure, white and black.
Arrow keys work too.</source>
        <translation>圆环：按颜料顺序排列的色相。三角形：纯色、白与黑。
也可使用方向键。</translation>
    </message>
</context>
<context>
    <name>suffuse::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Commands, brushes, docks, recent files</source>
        <translation>命令、画笔、面板、最近的文件</translation>
    </message>
    <message>
        <source>Parts of names in any order; Enter runs the chosen one, Escape goes back.</source>
        <translation>可按任意顺序输入名称的一部分；按回车键执行所选项，按 Esc 返回。</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>查找结果</translation>
    </message>
    <message>
        <source>Click one to run it.</source>
        <translation>点击即可执行。</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>没有匹配的名称。</translation>
    </message>
    <message>
        <source>It cannot be used now.</source>
        <translation>现在无法使用。</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>“%1” cannot be used now.</source>
        <translation>“%1”现在无法使用。</translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message>
        <source>&amp;New…</source>
        <translation>新建(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>关闭窗口(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>再制(&amp;L)</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>D&amp;eselect</source>
        <translation>取消选择(&amp;E)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Settin&amp;gs…</source>
        <translation>设置(&amp;S)…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>画笔(&amp;B)</translation>
    </message>
    <message>
        <source>Paint strokes</source>
        <translation>绘制笔画</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>选择(&amp;S)</translation>
    </message>
    <message>
        <source>Select and move strokes</source>
        <translation>选择和移动笔画</translation>
    </message>
    <message>
        <source>Se&amp;gments</source>
        <translation>线段(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>抓手(&amp;H)</translation>
    </message>
    <message>
        <source>Move the canvas</source>
        <translation>移动画布</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>上移一层(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Lower</source>
        <translation>下移一层(&amp;L)</translation>
    </message>
    <message>
        <source>Raise to &amp;Top</source>
        <translation>移到顶层(&amp;T)</translation>
    </message>
    <message>
        <source>Lower to &amp;Bottom</source>
        <translation>移到底层(&amp;B)</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit the Canvas</source>
        <translation>适合画布(&amp;F)</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>向左旋转(&amp;L)</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>向右旋转(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>恢复正向(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>镜像(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Hide the Docks</source>
        <translation>隐藏面板(&amp;H)</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>重置布局(&amp;Y)</translation>
    </message>
    <message>
        <source>Docks and tool bars go back to where they stand at the first start</source>
        <translation>面板和工具栏回到首次启动时的位置</translation>
    </message>
    <message>
        <source>Full S&amp;creen</source>
        <translation>全屏(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>键盘快捷键(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;About Suffuse…</source>
        <translation>关于 Suffuse(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>面板(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>原位粘贴(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Paste strokes where they were</source>
        <translation>将笔画粘贴到原来的位置</translation>
    </message>
    <message>
        <source>Edit segments, nodes and handles of strokes</source>
        <translation>编辑笔画的线段、节点和控制柄</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>刻刀(&amp;K)</translation>
    </message>
    <message>
        <source>Cut strokes along a line</source>
        <translation>沿一条线切割笔画</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>橡皮擦(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Attribute Brush</source>
        <translation>属性画笔(&amp;A)</translation>
    </message>
    <message>
        <source>Paint values onto segments</source>
        <translation>将数值绘制到线段上</translation>
    </message>
    <message>
        <source>Eye&amp;dropper</source>
        <translation>取色器(&amp;D)</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>拾取颜色</translation>
    </message>
    <message>
        <source>&amp;Insert Nodes</source>
        <translation>插入节点(&amp;I)</translation>
    </message>
    <message>
        <source>Insert a node into each selected segment</source>
        <translation>在每条所选线段中插入一个节点</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>尖角(&amp;C)</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Make the selected nodes corners</source>
        <translation>使所选节点变为尖角</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>平滑(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Make the selected nodes smooth</source>
        <translation>使所选节点变为平滑</translation>
    </message>
    <message>
        <source>S&amp;ymmetric</source>
        <translation>对称(&amp;Y)</translation>
    </message>
    <message>
        <source>Shift+Y</source>
        <translation>Shift+Y</translation>
    </message>
    <message>
        <source>Make the selected nodes symmetric</source>
        <translation>使所选节点变为对称</translation>
    </message>
    <message>
        <source>&amp;Break Strokes</source>
        <translation>断开笔画(&amp;B)</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Break strokes at the selected nodes</source>
        <translation>在所选节点处断开笔画</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>连接节点(&amp;J)</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Join two selected end nodes</source>
        <translation>连接所选的两个端点</translation>
    </message>
    <message>
        <source>&amp;Delete Segments</source>
        <translation>删除线段(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Brid&amp;ge Segments</source>
        <translation>桥接线段(&amp;G)</translation>
    </message>
    <message>
        <source>Alt+Del</source>
        <translation>Alt+Del</translation>
    </message>
    <message>
        <source>Replace selected segments by one that goes on smoothly</source>
        <translation>用一条平滑延续的线段替换所选线段</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>反向(&amp;R)</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>Let the selected strokes run from end to start</source>
        <translation>使所选笔画从终点走向起点</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>对象(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>节点(&amp;N)</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>反选(&amp;V)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>!</source>
        <translation>!</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>Select all strokes of the same colour</source>
        <translation>选择相同颜色的所有笔画</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>样式(&amp;S)</translation>
    </message>
    <message>
        <source>Select all strokes of the same style</source>
        <translation>选择相同样式的所有笔画</translation>
    </message>
    <message>
        <source>Select all strokes of the same brush</source>
        <translation>选择相同画笔的所有笔画</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>套索(&amp;L)</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Select what is drawn around; with Shift from paint, too</source>
        <translation>选择圈住的内容；按住 Shift 也可从颜料上开始</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>触碰(&amp;T)</translation>
    </message>
    <message>
        <source>Select what a path touches</source>
        <translation>选择路径触碰到的内容</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>群组(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>解除群组(&amp;U)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>锁定(&amp;K)</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>全部解锁(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>全部显示(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>重命名(&amp;M)…</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Flip Hori&amp;zontally</source>
        <translation>水平翻转(&amp;Z)</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>垂直翻转(&amp;V)</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Rotate by &amp;90° Left</source>
        <translation>向左旋转 90°(&amp;E)</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate by 90° R&amp;ight</source>
        <translation>向右旋转 90°(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>&amp;Scale Spread with the Shape</source>
        <translation>扩散随形状缩放(&amp;S)</translation>
    </message>
    <message>
        <source>Spread and density follow the shape when it is scaled</source>
        <translation>缩放形状时，扩散距离和密度随之变化</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>左边缘对齐(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Centres, Horizontally</source>
        <translation>水平居中对齐(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>右边缘对齐(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>上边缘对齐(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Middles, Vertically</source>
        <translation>垂直居中对齐(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>下边缘对齐(&amp;B)</translation>
    </message>
    <message>
        <source>Relative to the &amp;Selection</source>
        <translation>相对于所选内容(&amp;S)</translation>
    </message>
    <message>
        <source>Relative to the C&amp;anvas</source>
        <translation>相对于画布(&amp;A)</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Horizontally</source>
        <translation>水平间距均等(&amp;H)</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Vertically</source>
        <translation>垂直间距均等(&amp;V)</translation>
    </message>
    <message>
        <source>Even &amp;Centres, Horizontally</source>
        <translation>中心水平等距(&amp;C)</translation>
    </message>
    <message>
        <source>Even C&amp;entres, Vertically</source>
        <translation>中心垂直等距(&amp;E)</translation>
    </message>
    <message>
        <source>Snap to &amp;Nodes</source>
        <translation>吸附到节点(&amp;N)</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>吸附到网格(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Show the Grid</source>
        <translation>显示网格(&amp;S)</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Grid St&amp;ep…</source>
        <translation>网格间距(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>分布(&amp;D)</translation>
    </message>
    <message>
        <source>Select Sa&amp;me</source>
        <translation>选择相同项(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Ti&amp;me</source>
        <translation>时间(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Favourite Brushes</source>
        <translation>收藏的画笔(&amp;F)</translation>
    </message>
    <message>
        <source>Favourite Brush %1</source>
        <translation>收藏的画笔 %1</translation>
    </message>
    <message>
        <source>Relative to the &amp;First Selected</source>
        <translation>相对于最先选择的笔画(&amp;F)</translation>
    </message>
    <message>
        <source>Relative to the Bi&amp;ggest</source>
        <translation>相对于最大的笔画(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Play the painting being painted, or pause</source>
        <translation>播放作画过程，或暂停</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>转到开头(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+,</source>
        <translation>Shift+,</translation>
    </message>
    <message>
        <source>Go to where the painting begins</source>
        <translation>转到画作开始之处</translation>
    </message>
    <message>
        <source>P&amp;revious Stroke</source>
        <translation>上一笔(&amp;R)</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Go back to where a stroke begins</source>
        <translation>退回到某一笔画开始之处</translation>
    </message>
    <message>
        <source>&amp;Next Stroke</source>
        <translation>下一笔(&amp;N)</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Go on to where a stroke begins</source>
        <translation>前进到某一笔画开始之处</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>转到结尾(&amp;E)</translation>
    </message>
    <message>
        <source>Shift+.</source>
        <translation>Shift+.</translation>
    </message>
    <message>
        <source>Go to the end, where all has dried: the present</source>
        <translation>转到全部干透的结尾：即现在</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>循环(&amp;L)</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>循环播放</translation>
    </message>
    <message>
        <source>S&amp;kip Pauses</source>
        <translation>跳过停顿(&amp;K)</translation>
    </message>
    <message>
        <source>Cut pauses in which nothing is painted or spreads to half a second</source>
        <translation>将没有绘制也没有扩散的停顿缩短为半秒</translation>
    </message>
    <message>
        <source>Preview When &amp;Dry</source>
        <translation>干透预览(&amp;D)</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Show wet paint as it will look when it has dried, while you paint too</source>
        <translation>将未干的颜料显示为干透后的样子，作画时也是如此</translation>
    </message>
    <message>
        <source>Let It Dr&amp;y</source>
        <translation>等待干透(&amp;Y)</translation>
    </message>
    <message>
        <source>Go to the moment at which all has dried</source>
        <translation>转到全部干透的时刻</translation>
    </message>
    <message>
        <source>&amp;Freeze Wet Paint</source>
        <translation>冻结未干颜料(&amp;F)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+F</source>
        <translation>Ctrl+Alt+F</translation>
    </message>
    <message>
        <source>All that is wet stops spreading at this moment</source>
        <translation>所有未干的颜料在此刻停止扩散</translation>
    </message>
    <message>
        <source>Re-&amp;wet…</source>
        <translation>再次润湿(&amp;W)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Let the selected paint spread on for a while from this moment</source>
        <translation>使所选颜料从此刻起继续扩散一段时间</translation>
    </message>
    <message>
        <source>Remove Re-we&amp;tting</source>
        <translation>移除再次润湿(&amp;T)</translation>
    </message>
    <message>
        <source>The selected paint dries once and for all</source>
        <translation>所选颜料一次干透，不再润湿</translation>
    </message>
    <message>
        <source>&amp;Even</source>
        <translation>匀速(&amp;E)</translation>
    </message>
    <message>
        <source>Selected strokes are drawn at an even pace</source>
        <translation>所选笔画以均匀的速度绘制</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>缓入(&amp;I)</translation>
    </message>
    <message>
        <source>Selected strokes begin slowly</source>
        <translation>所选笔画开始时较慢</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>缓出(&amp;O)</translation>
    </message>
    <message>
        <source>Selected strokes end slowly</source>
        <translation>所选笔画结束时较慢</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>缓入缓出(&amp;U)</translation>
    </message>
    <message>
        <source>Selected strokes begin and end slowly</source>
        <translation>所选笔画开始和结束时较慢</translation>
    </message>
    <message>
        <source>Export Ti&amp;melapse…</source>
        <translation>导出缩时视频(&amp;M)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Make a film of the painting being painted</source>
        <translation>将作画过程制成影片</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>绘制节奏(&amp;C)</translation>
    </message>
    <message>
        <source>Relative to the Last Select&amp;ed</source>
        <translation>相对于最后选择的笔画(&amp;E)</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File</source>
        <translation>在文件中保留撤销历史(&amp;H)</translation>
    </message>
    <message>
        <source>Whoever opens the file can go on undoing. Take it out before you give a file away</source>
        <translation>打开此文件的人可以继续撤销。将文件交给他人之前请取消此项</translation>
    </message>
    <message>
        <source>Import &amp;Underlay…</source>
        <translation>导入底图(&amp;U)…</translation>
    </message>
    <message>
        <source>A picture to paint over, which shows on the canvas only</source>
        <translation>供描绘参考的图片，只在画布上显示</translation>
    </message>
    <message>
        <source>Show the Underl&amp;ay</source>
        <translation>显示底图(&amp;A)</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>&amp;Import Strokes…</source>
        <translation>导入笔画(&amp;I)…</translation>
    </message>
    <message>
        <source>Drawings, recordings and the strokes of other paintings, into this one</source>
        <translation>将图形、笔迹记录和其他画作的笔画导入本画作</translation>
    </message>
    <message>
        <source>S&amp;maller Tool Size</source>
        <translation>缩小工具(&amp;M)</translation>
    </message>
    <message>
        <source>La&amp;rger Tool Size</source>
        <translation>放大工具(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Less Opacity</source>
        <translation>降低不透明度(&amp;L)</translation>
    </message>
    <message>
        <source>More &amp;Opacity</source>
        <translation>提高不透明度(&amp;O)</translation>
    </message>
    <message>
        <source>Move the Canvas While Held</source>
        <translation>按住时移动画布</translation>
    </message>
    <message>
        <source>Turn the Canvas While Held</source>
        <translation>按住时旋转画布</translation>
    </message>
    <message>
        <source>Move the Selection</source>
        <translation>移动所选</translation>
    </message>
    <message>
        <source>Move the Selection Ten Times as Far</source>
        <translation>以十倍距离移动所选</translation>
    </message>
    <message>
        <source>Move the Selection by One Unit</source>
        <translation>将所选移动一个单位</translation>
    </message>
    <message>
        <source>Move the Selection by Ten Units</source>
        <translation>将所选移动十个单位</translation>
    </message>
    <message>
        <source>Move Rows in the Strokes Dock</source>
        <translation>在“笔画”面板中移动行</translation>
    </message>
    <message>
        <source>Previous Stroke or Node</source>
        <translation>上一笔画或节点</translation>
    </message>
    <message>
        <source>Give Up, or Deselect</source>
        <translation>放弃或取消选择</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>保存副本(&amp;Y)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+S</source>
        <translation>Ctrl+Alt+Shift+S</translation>
    </message>
    <message>
        <source>Into another file; you go on painting in this one</source>
        <translation>存入另一个文件；继续在当前文件中绘制</translation>
    </message>
    <message>
        <source>Re&amp;vert…</source>
        <translation>还原到文件(&amp;V)…</translation>
    </message>
    <message>
        <source>Back to what the file holds; Undo takes it back</source>
        <translation>回到文件中的内容；可以撤销</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>恢复备份(&amp;B)…</translation>
    </message>
    <message>
        <source>Back to an earlier version of the file</source>
        <translation>回到文件的早先版本</translation>
    </message>
    <message>
        <source>Export A&amp;gain</source>
        <translation>再次导出(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>To the same file, with the same settings</source>
        <translation>以相同设置导出到同一文件</translation>
    </message>
    <message>
        <source>Hide Outlines and Handles While Held</source>
        <translation>按住时隐藏轮廓线和手柄</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Select all strokes of the same name</source>
        <translation>选择名称相同的所有笔画</translation>
    </message>
    <message>
        <source>Select &amp;Found</source>
        <translation>选择搜索结果(&amp;F)</translation>
    </message>
    <message>
        <source>Select what the search in the Strokes dock has found</source>
        <translation>选择“笔画”面板中搜索到的内容</translation>
    </message>
    <message>
        <source>Find Strokes</source>
        <translation>搜索笔画</translation>
    </message>
    <message>
        <source>Look for strokes and groups by their names, in the Strokes dock</source>
        <translation>在“笔画”面板中按名称搜索笔画和组</translation>
    </message>
    <message>
        <source>Show Ou&amp;tlines</source>
        <translation>显示轮廓线(&amp;T)</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Lines along the selected strokes; the Brush shows none</source>
        <translation>沿所选笔画的线条；使用画笔时不显示</translation>
    </message>
    <message>
        <source>Show Paint &amp;beyond the Canvas</source>
        <translation>显示画布外的颜料(&amp;B)</translation>
    </message>
    <message>
        <source>Under a veil, what was painted beside the canvas; it is in no picture that is exported</source>
        <translation>以半透明遮罩显示画在画布之外的内容；导出的图片中不包含它</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>下一个面板(&amp;X)</translation>
    </message>
    <message>
        <source>The keyboard goes from the canvas to the docks and tool bars in turn</source>
        <translation>键盘焦点从画布依次移到各面板和工具栏</translation>
    </message>
    <message>
        <source>&amp;Previous Panel</source>
        <translation>上一个面板(&amp;K)</translation>
    </message>
    <message>
        <source>The keyboard goes back from panel to panel</source>
        <translation>键盘焦点依次移回上一个面板</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>查找命令(&amp;F)…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Commands, brushes, docks and recent files by their names</source>
        <translation>按名称查找命令、画笔、面板和最近的文件</translation>
    </message>
    <message>
        <source>Drawing pace</source>
        <translation>绘制节奏</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>移除再次润湿</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File (%1)</source>
        <translation>在文件中保留撤销历史(&amp;H)（%1）</translation>
    </message>
    <message>
        <source>Canvas, while held</source>
        <translation>画布（按住时）</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>任何位置</translation>
    </message>
    <message>
        <source>Canvas, Strokes dock</source>
        <translation>画布、“笔画”面板</translation>
    </message>
    <message>
        <source>Canvas, Timeline dock</source>
        <translation>画布、“时间轴”面板</translation>
    </message>
    <message>
        <source>Canvas, Segments tool</source>
        <translation>画布，线段工具</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Nothing is wet at this moment.</source>
        <translation>此刻没有未干的颜料。</translation>
    </message>
    <message>
        <source>Freeze wet paint</source>
        <translation>冻结未干颜料</translation>
    </message>
    <message>
        <source>Nothing that is selected is painted yet at this moment.</source>
        <translation>此刻所选内容尚未绘制。</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>组的名称</translation>
    </message>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画的名称</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Re-wet</source>
        <translation>再次润湿</translation>
    </message>
    <message>
        <source>Seconds that the paint spreads on</source>
        <translation>颜料继续扩散的秒数</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Smooth the curves of the selected strokes; each time more</source>
        <translation>平滑所选笔画的曲线；每次更平滑</translation>
    </message>
    <message>
        <source>S&amp;traighten</source>
        <translation>拉直(&amp;T)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Move the selected strokes towards straight lines; each time more</source>
        <translation>使所选笔画趋向直线；每次更直</translation>
    </message>
    <message>
        <source>&amp;Grow Paint</source>
        <translation>加宽颜料(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+)</source>
        <translation>Ctrl+)</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes wider</source>
        <translation>使所选笔画的颜料更宽</translation>
    </message>
    <message>
        <source>S&amp;hrink Paint</source>
        <translation>缩窄颜料(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+(</source>
        <translation>Ctrl+(</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes narrower</source>
        <translation>使所选笔画的颜料更窄</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>所选内容已锁定或隐藏。</translation>
    </message>
    <message>
        <source>Simp&amp;lify…</source>
        <translation>简化(&amp;L)…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Make fewer segments of the selected strokes</source>
        <translation>减少所选笔画的线段数</translation>
    </message>
    <message>
        <source>&amp;Offset and More…</source>
        <translation>偏移及更多(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Offset, smooth, straighten, grow or shrink the selected strokes by numbers</source>
        <translation>按数值偏移、平滑、拉直、加宽或缩窄所选笔画</translation>
    </message>
    <message>
        <source>Resha&amp;pe</source>
        <translation>整形(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>填充(&amp;J)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Wet what the selected strokes enclose; the inspector has its values</source>
        <translation>润湿所选笔画围住的区域；其数值在检查器中</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Remove Fill</source>
        <translation>移除填充</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>移除填充</translation>
    </message>
    <message>
        <source>Leave of the selected strokes their outlines</source>
        <translation>只保留所选笔画的轮廓</translation>
    </message>
    <message>
        <source>Geome&amp;tric Shapes</source>
        <translation>几何形状(&amp;T)</translation>
    </message>
    <message>
        <source>Paint rectangles, ellipses, polygons and stars</source>
        <translation>绘制矩形、椭圆、多边形和星形</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>重绘(&amp;W)</translation>
    </message>
    <message>
        <source>Draw over a part of a stroke, which follows the new line</source>
        <translation>在笔画的一段上绘制，该段将跟随新线条</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>推移(&amp;P)</translation>
    </message>
    <message>
        <source>Push, comb, pinch or roughen strokes</source>
        <translation>推移、梳理、收拢或粗糙化笔画</translation>
    </message>
    <message>
        <source>What lies under the pointer, and what can be done with it</source>
        <translation>指针下有什么，以及可以对它做什么</translation>
    </message>
    <message>
        <source>Br&amp;ush Palette at the Pointer</source>
        <translation>指针处的画笔面板(&amp;U)</translation>
    </message>
    <message>
        <source>Brushes, colours, size and zoom where the pointer is</source>
        <translation>在指针处选择画笔、颜色、大小和缩放</translation>
    </message>
    <message>
        <source>Edit Value&amp;s Here…</source>
        <translation>在此编辑数值(&amp;H)…</translation>
    </message>
    <message>
        <source>Width, diffusion, density, colour and opacity of what is selected, at the pointer</source>
        <translation>在指针处编辑所选内容的宽度、扩散、密度、颜色和不透明度</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>整个画笔(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Put the brush in hand on the selected strokes; they remember the pen&apos;s pressure</source>
        <translation>将当前画笔应用于所选笔画；笔画会记住落笔时的压感</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>仅形态(&amp;F)</translation>
    </message>
    <message>
        <source>Width, density, tapering and tip of the brush in hand</source>
        <translation>当前画笔的宽度、密度、收尖和笔尖</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>仅颜色(&amp;C)</translation>
    </message>
    <message>
        <source>Colour and opacity of the brush in hand</source>
        <translation>当前画笔的颜色和不透明度</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>仅质感(&amp;T)</translation>
    </message>
    <message>
        <source>Style, mixing, grain and drying time of the brush in hand</source>
        <translation>当前画笔的样式、混合、颗粒和干燥时间</translation>
    </message>
    <message>
        <source>C&amp;opy Appearance</source>
        <translation>复制外观(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy style, mixing, values and colour of the stroke that was selected last</source>
        <translation>复制最后选择的笔画的样式、混合、数值和颜色</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Put it on the selected strokes; what varies along them goes on varying</source>
        <translation>应用于所选笔画；沿笔画的变化得以保留</translation>
    </message>
    <message>
        <source>Paste Appearance Evenl&amp;y</source>
        <translation>均匀粘贴外观(&amp;Y)</translation>
    </message>
    <message>
        <source>Put it on the selected strokes, with the same values all along</source>
        <translation>应用于所选笔画，且全程使用相同的值</translation>
    </message>
    <message>
        <source>Along th&amp;e Stroke…</source>
        <translation>沿笔画变化(&amp;F)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Set a value along the stroke: constant, as a ramp, or drawn as a curve</source>
        <translation>设置沿笔画变化的值：恒定、渐变或手绘曲线</translation>
    </message>
    <message>
        <source>Vary at Rand&amp;om…</source>
        <translation>随机变化(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Y</source>
        <translation>Ctrl+Alt+Y</translation>
    </message>
    <message>
        <source>Let values and colours of the selected strokes stray at random</source>
        <translation>让所选笔画的数值和颜色随机偏移</translation>
    </message>
    <message>
        <source>Appl&amp;y Brush</source>
        <translation>应用画笔(&amp;Y)</translation>
    </message>
    <message>
        <source>Show Erasures</source>
        <translation>显示擦除</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>Dashed lines along what was erased softly from all strokes; what is not selected is paler</source>
        <translation>用虚线标出从所有笔画柔和擦去之处；未选择的较淡</translation>
    </message>
    <message>
        <source>&amp;Combine</source>
        <translation>合并(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Make one stroke of the selected ones, whose paint adds up</source>
        <translation>将所选笔画合为一条，其颜料相加</translation>
    </message>
    <message>
        <source>Break Apart</source>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Make strokes of the parts of the selected ones</source>
        <translation>将所选笔画的各部分变成独立的笔画</translation>
    </message>
    <message>
        <source>Remove Erasures</source>
        <translation>移除擦除</translation>
    </message>
    <message>
        <source>Bring back what was erased softly from the selected strokes, or by the selected segments</source>
        <translation>恢复从所选笔画柔和擦去的、或由所选线段擦去的颜料</translation>
    </message>
    <message>
        <source>Delete the selected segments, which leaves gaps in strokes</source>
        <translation>删除所选线段，笔画中留下空隙</translation>
    </message>
    <message>
        <source>Take paint away softly, or cut out parts of strokes</source>
        <translation>柔和地擦去颜料，或剪除笔画的部分</translation>
    </message>
    <message>
        <source>Map Colours to S&amp;watches</source>
        <translation>将颜色映射到色板(&amp;W)</translation>
    </message>
    <message>
        <source>Give what is selected, or else all of the painting, the swatches that look nearest</source>
        <translation>为所选内容（若无则为整幅画）换上看起来最接近的色板</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Give each colour of the painting, or of what is selected, another one everywhere</source>
        <translation>将画中或所选内容中的每种颜色全部换成另一种</translation>
    </message>
    <message>
        <source>Paste Appeara&amp;nce</source>
        <translation>粘贴外观(&amp;N)</translation>
    </message>
    <message>
        <source>Menu at t&amp;he Pointer</source>
        <translation>指针处的菜单(&amp;G)</translation>
    </message>
    <message>
        <source>Recolour Artwor&amp;k…</source>
        <translation>重新着色图稿(&amp;K)…</translation>
    </message>
    <message>
        <source>Match &amp;by Eyedropper</source>
        <translation>用取色器匹配(&amp;B)</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its style, mixing, values and colour</source>
        <translation>点击一条笔画：所选笔画获得其样式、混合、数值和颜色</translation>
    </message>
    <message>
        <source>A fill cannot be wetted again. It spreads as long as it takes to dry.</source>
        <translation>填充无法再次润湿。它在干燥之前会一直扩散。</translation>
    </message>
    <message>
        <source>Not done: nothing would be left.</source>
        <translation>未执行：不会剩下任何内容。</translation>
    </message>
    <message>
        <source>Not done: the outlines meet so often that it would take minutes.</source>
        <translation>未执行：轮廓相交过多，将需要数分钟。</translation>
    </message>
    <message>
        <source>Not done: the outlines lie on each other so closely that the result is uncertain.</source>
        <translation>未执行：轮廓重叠得过于紧密，结果不可靠。</translation>
    </message>
    <message>
        <source>Select two or more filled strokes.</source>
        <translation>请选择两条或更多已填充的笔画。</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>并集(&amp;U)</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>One fill of what the selected ones cover, with the values of the lowest</source>
        <translation>将所选填充覆盖的区域合成一个填充，采用最底层的数值</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>差集(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what the others do not cover</source>
        <translation>只保留最底层所选填充中未被其他填充覆盖的部分</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>交集(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+*</source>
        <translation>Ctrl+*</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what all others cover</source>
        <translation>只保留最底层所选填充中被所有其他填充覆盖的部分</translation>
    </message>
    <message>
        <source>E&amp;xclusion</source>
        <translation>排除(&amp;X)</translation>
    </message>
    <message>
        <source>Ctrl+^</source>
        <translation>Ctrl+^</translation>
    </message>
    <message>
        <source>One fill of what one of the selected ones covers, and not two</source>
        <translation>将只被一个所选填充覆盖的区域合成一个填充</translation>
    </message>
    <message>
        <source>Di&amp;vision</source>
        <translation>分割(&amp;V)</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Cut the lowest selected fill along the outlines of the others</source>
        <translation>沿其他填充的轮廓切开最底层的所选填充</translation>
    </message>
    <message>
        <source>Select a filled stroke.</source>
        <translation>请选择一条已填充的笔画。</translation>
    </message>
    <message>
        <source>I&amp;nset</source>
        <translation>内缩(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+(</source>
        <translation>Ctrl+Alt+(</translation>
    </message>
    <message>
        <source>Move the outlines of fills inwards, by the distance of Offset and More</source>
        <translation>按“偏移及更多”中的距离向内移动填充的轮廓</translation>
    </message>
    <message>
        <source>&amp;Outset</source>
        <translation>外扩(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+)</source>
        <translation>Ctrl+Alt+)</translation>
    </message>
    <message>
        <source>Move the outlines of fills outwards, by the distance of Offset and More</source>
        <translation>按“偏移及更多”中的距离向外移动填充的轮廓</translation>
    </message>
    <message>
        <source>&amp;Stroke to Outline</source>
        <translation>笔画转为轮廓(&amp;S)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Make fills of what is seen of the lines of the selected strokes</source>
        <translation>将所选笔画中可见的线条变成填充</translation>
    </message>
    <message>
        <source>Stroke to outline</source>
        <translation>笔画转为轮廓</translation>
    </message>
    <message>
        <source>Select a stroke of which a line is seen.</source>
        <translation>请选择一条可见线条的笔画。</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>区域运算</translation>
    </message>
    <message>
        <source>Outline Pe&amp;n</source>
        <translation>轮廓钢笔(&amp;N)</translation>
    </message>
    <message>
        <source>Draw an outline node by node, filled or not</source>
        <translation>逐个节点绘制轮廓，可填充</translation>
    </message>
    <message>
        <source>Lasso F&amp;ill</source>
        <translation>套索填充(&amp;I)</translation>
    </message>
    <message>
        <source>Fill what is drawn around</source>
        <translation>填充所圈出的区域</translation>
    </message>
    <message>
        <source>Bu&amp;cket</source>
        <translation>油漆桶(&amp;C)</translation>
    </message>
    <message>
        <source>Fill what the paint around a place bounds</source>
        <translation>填充某处周围颜料所围住的区域</translation>
    </message>
    <message>
        <source>Text to Strokes</source>
        <translation>文字转为笔画</translation>
    </message>
    <message>
        <source>Make plain strokes of the letters of the selected texts; they cannot be typed in any more</source>
        <translation>把所选文字的字变成普通笔画；此后不能再键入</translation>
    </message>
    <message>
        <source>Text to strokes</source>
        <translation>文字转为笔画</translation>
    </message>
    <message>
        <source>Release Text from Stroke</source>
        <translation>让文字脱离笔画</translation>
    </message>
    <message>
        <source>Let the selected texts keep their curves, whatever becomes of the strokes that they follow</source>
        <translation>所选文字保留自己的曲线，不再随所跟随的笔画改变</translation>
    </message>
    <message>
        <source>Select a text that follows a stroke.</source>
        <translation>请选择一段跟随笔画的文字。</translation>
    </message>
    <message>
        <source>Release text from stroke</source>
        <translation>让文字脱离笔画</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>文字(&amp;X)</translation>
    </message>
    <message>
        <source>Type texts, whose letters are strokes</source>
        <translation>键入文字，其中每个字都是笔画</translation>
    </message>
    <message>
        <source>&amp;Zoom to Selection</source>
        <translation>缩放到所选内容(&amp;Z)</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Show what is selected as large as possible: strokes, segments or nodes</source>
        <translation>尽可能大地显示所选内容：笔画、线段或节点</translation>
    </message>
    <message>
        <source>Add Gradient</source>
        <translation>添加渐变</translation>
    </message>
    <message>
        <source>The colour of the selected fills fades from left to right; needs a fill of one colour</source>
        <translation>所选填充的颜色从左到右渐变；需要单色填充</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>添加渐变</translation>
    </message>
    <message>
        <source>Remove Gradient</source>
        <translation>移除渐变</translation>
    </message>
    <message>
        <source>The selected fills have their first colour everywhere; needs a fill with a gradient</source>
        <translation>所选填充处处为其第一种颜色；需要带渐变的填充</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>移除渐变</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>剪贴到下方</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>The selected groups are seen only where the next thing below them in the same group is; needs something below</source>
        <translation>所选组只在同一组内紧挨其下的对象所在之处可见；下方需有对象</translation>
    </message>
    <message>
        <source>Use as Mask</source>
        <translation>用作蒙版</translation>
    </message>
    <message>
        <source>What is beside the selected groups is seen only where they have paint; needs something beside</source>
        <translation>所选组旁边的内容只在它们有颜料的地方可见；旁边需有内容</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>淡彩</translation>
    </message>
    <message>
        <source>The strokes of the selected groups are one, laid wet into wet</source>
        <translation>所选组的笔画各自合为一笔，湿画在湿上</translation>
    </message>
    <message>
        <source>What the group did as a whole (opacity, mode, isolation, clip, mask, wash) is gone with it.</source>
        <translation>该组作为整体的作用（不透明度、模式、自行混合、剪贴、蒙版、淡彩）随之消失。</translation>
    </message>
    <message>
        <source>Group as a Whole</source>
        <translation>组作为整体</translation>
    </message>
    <message>
        <source>Not merged: nothing lies below the layer in its group.</source>
        <translation>未合并：在其群组中，图层之下没有内容。</translation>
    </message>
    <message>
        <source>Not merged: what lies just below the layer is no layer.</source>
        <translation>未合并：紧接图层之下的不是图层。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is hidden.</source>
        <translation>未合并：两个图层之一被隐藏。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is locked.</source>
        <translation>未合并：两个图层之一被锁定。</translation>
    </message>
    <message>
        <source>Merge layer down</source>
        <translation>向下合并图层</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>复制图层</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>上移图层</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>下移图层</translation>
    </message>
    <message>
        <source>&amp;New Layer</source>
        <translation>新建图层(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paint on a new layer above this one; it comes with its first stroke</source>
        <translation>在此图层之上的新图层上绘画；画下第一笔时图层才会出现</translation>
    </message>
    <message>
        <source>New &amp;Clipped Layer</source>
        <translation>新建剪贴图层(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Paint on a new layer that shows only where the layer below has paint: a clipping mask</source>
        <translation>在新图层上绘画，只在下方图层有颜料之处显示：剪贴蒙版</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>复制图层(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>向下合并(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Raise Layer</source>
        <translation>上移图层(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Lower Layer</source>
        <translation>下移图层(&amp;L)</translation>
    </message>
    <message>
        <source>Layer &amp;Above</source>
        <translation>上一图层(&amp;A)</translation>
    </message>
    <message>
        <source>Paint on the next layer above; above all of them there is none</source>
        <translation>在上面一个图层上绘画；最上面之上则不用图层</translation>
    </message>
    <message>
        <source>Layer &amp;Below</source>
        <translation>下一图层(&amp;B)</translation>
    </message>
    <message>
        <source>Paint on the next layer below</source>
        <translation>在下面一个图层上绘画</translation>
    </message>
    <message>
        <source>N&amp;o Layer</source>
        <translation>不用图层(&amp;O)</translation>
    </message>
    <message>
        <source>Paint on top of all again</source>
        <translation>重新在所有内容之上绘画</translation>
    </message>
    <message>
        <source>&amp;Hide Others</source>
        <translation>隐藏其他图层(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Show only this layer, or all again</source>
        <translation>只显示此图层，或重新显示全部</translation>
    </message>
    <message>
        <source>Show other layers</source>
        <translation>显示其他图层</translation>
    </message>
    <message>
        <source>Hide other layers</source>
        <translation>隐藏其他图层</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>图层(&amp;L)</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>没有变化。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is a mask, and the picture would change.</source>
        <translation>未合并：两个图层之一是蒙版，合并会改变画面。</translation>
    </message>
    <message>
        <source>Not merged: the layer below is clipped, and the picture would change.</source>
        <translation>未合并：下方的图层有剪贴，合并会改变画面。</translation>
    </message>
    <message>
        <source>Not merged: what lies above is clipped to this layer, and the picture would change.</source>
        <translation>未合并：上方内容剪贴到此图层，合并会改变画面。</translation>
    </message>
    <message>
        <source>So that the picture stays, %1 is a group of its own within %2.</source>
        <translation>为保持画面不变，%1 成为 %2 中的一个组。</translation>
    </message>
    <message>
        <source>Put the layer onto the one just below it; the picture stays</source>
        <translation>把图层并入紧接其下的图层；画面不变</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>图层(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;This Layer Only</source>
        <translation>仅此图层(&amp;T)</translation>
    </message>
    <message>
        <source>Tools reach only what is on the layer, where there is one</source>
        <translation>工具只触及图层上的内容（如果有图层）</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>The selected groups are seen here, and left out of what is exported</source>
        <translation>所选的组在此可见，但不会被导出</translation>
    </message>
    <message>
        <source>Underlay to Layer</source>
        <translation>底图转为图层</translation>
    </message>
    <message>
        <source>Make an image layer below all of the underlay, where it lies; it is exported then</source>
        <translation>将底图原位转为最下方的图像图层；之后它会被导出</translation>
    </message>
    <message>
        <source>Picture to Stro&amp;kes…</source>
        <translation>图片转为笔画(&amp;K)…</translation>
    </message>
    <message>
        <source>Strokes that look like a picture, of a file or the underlay, as a layer</source>
        <translation>将文件或底图中的图片转为外观相同的笔画，作为图层</translation>
    </message>
    <message>
        <source>Import &amp;Picture as Layer…</source>
        <translation>将图片导入为图层(&amp;P)…</translation>
    </message>
    <message>
        <source>A picture as a layer among the others: with opacity and mode, and in what is exported</source>
        <translation>图片作为与其他图层一样的图层：有不透明度和模式，并会被导出</translation>
    </message>
    <message>
        <source>Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one</source>
        <translation>在指针处粘贴笔画、SVG 路径或图片；颜色则成为当前颜色</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>导出图形(&amp;D)…</translation>
    </message>
    <message>
        <source>Prin&amp;t…</source>
        <translation>打印(&amp;T)…</translation>
    </message>
    <message>
        <source>On paper, or as a page of a PDF file</source>
        <translation>打印到纸上，或输出为 PDF 文件的一页</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>打印预览(&amp;W)…</translation>
    </message>
    <message>
        <source>See the page in large before it is printed</source>
        <translation>打印前放大查看页面</translation>
    </message>
    <message>
        <source>Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)</source>
        <translation>为 Inkscape、绘图仪和浏览器导出颜料的精确轮廓和条带（SVG）</translation>
    </message>
    <message>
        <source>Soft Proof</source>
        <translation>色彩校样</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>Shows the colours that are left on another device, as a press, by its profile</source>
        <translation>按其他设备（如印刷机）的配置文件显示在那里还剩下的颜色</translation>
    </message>
    <message>
        <source>Gamut &amp;Warning</source>
        <translation>色域警告(&amp;C)</translation>
    </message>
    <message>
        <source>Marks the colours that the device of the soft proof does not have</source>
        <translation>标记校样设备没有的颜色</translation>
    </message>
    <message>
        <source>Soft Proof with Profile…</source>
        <translation>用配置文件校样…</translation>
    </message>
    <message>
        <source>Chooses the profile of the device whose colours are shown</source>
        <translation>选择要显示其颜色的设备的配置文件</translation>
    </message>
    <message>
        <source>It is clipped to a layer that is hidden now, so nothing of it is seen.</source>
        <translation>它被剪贴到现已隐藏的图层，因此看不到任何内容。</translation>
    </message>
    <message>
        <source>&amp;Fewer Strokes…</source>
        <translation>减少笔画(&amp;F)…</translation>
    </message>
    <message>
        <source>Make fewer strokes that look like the selected ones</source>
        <translation>生成外观与所选笔画相同但更少的笔画</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>What Suffuse does and how; the key opens the page about what you are working with</source>
        <translation>Suffuse 的功能和用法；按键会打开与当前操作有关的一页</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>&amp;Welcome…</source>
        <translation>欢迎(&amp;W)…</translation>
    </message>
    <message>
        <source>New paintings, recent ones, samples, and short lessons</source>
        <translation>新画作、最近的画作、示例和短课程</translation>
    </message>
    <message>
        <source>Nothing is selected: click paint with Select first.</source>
        <translation>没有选中任何内容：请先用“选择”点击颜料。</translation>
    </message>
    <message>
        <source>Nothing is painted yet.</source>
        <translation>还没有画任何内容。</translation>
    </message>
    <message>
        <source>Nothing is locked.</source>
        <translation>没有锁定的内容。</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>没有隐藏的内容。</translation>
    </message>
    <message>
        <source>Select two strokes or more; to the canvas one can be aligned, too.</source>
        <translation>请选择两条或更多笔画；对齐到画布时一条也可以。</translation>
    </message>
    <message>
        <source>No layer is chosen: click one in the Strokes dock, or begin one with New Layer.</source>
        <translation>没有选定图层：请在“笔画”面板中点击一个，或用“新建图层”开始一个。</translation>
    </message>
    <message>
        <source>The painting has no layers yet: New Layer begins one.</source>
        <translation>画作还没有图层：用“新建图层”开始一个。</translation>
    </message>
    <message>
        <source>Select a group that this can be.</source>
        <translation>请选择一个可以这样设置的组。</translation>
    </message>
    <message>
        <source>Select strokes of a group.</source>
        <translation>请选择某个组里的笔画。</translation>
    </message>
    <message>
        <source>Select a text.</source>
        <translation>请选择一段文字。</translation>
    </message>
    <message>
        <source>Select strokes without a fill.</source>
        <translation>请选择没有填充的笔画。</translation>
    </message>
    <message>
        <source>Select a fill of one colour.</source>
        <translation>请选择单色的填充。</translation>
    </message>
    <message>
        <source>Select a fill with a gradient.</source>
        <translation>请选择带渐变的填充。</translation>
    </message>
    <message>
        <source>Select two strokes or more.</source>
        <translation>请选择两条或更多笔画。</translation>
    </message>
    <message>
        <source>Select a stroke that was combined or cut into parts.</source>
        <translation>请选择一条合并过或被切开的笔画。</translation>
    </message>
    <message>
        <source>Select a stroke from which something was erased softly.</source>
        <translation>请选择一条被柔和擦除过的笔画。</translation>
    </message>
    <message>
        <source>The painting has no underlay.</source>
        <translation>画作没有底图。</translation>
    </message>
    <message>
        <source>Select paint that was wetted again.</source>
        <translation>请选择重新弄湿过的颜料。</translation>
    </message>
    <message>
        <source>Copy an appearance first.</source>
        <translation>请先复制外观。</translation>
    </message>
    <message>
        <source>The painting has no swatches.</source>
        <translation>画作没有色板。</translation>
    </message>
    <message>
        <source>The painting has no file yet: save it first.</source>
        <translation>画作还没有文件：请先保存。</translation>
    </message>
    <message>
        <source>The clipboard has nothing that can be painted.</source>
        <translation>剪贴板里没有可以画出的内容。</translation>
    </message>
    <message>
        <source>An export is still under way.</source>
        <translation>仍在导出。</translation>
    </message>
    <message>
        <source>Search in the Strokes dock first.</source>
        <translation>请先在“笔画”面板中搜索。</translation>
    </message>
    <message>
        <source>Switch the soft proof on first.</source>
        <translation>请先打开色彩校样。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>Select nodes with Segments first.</source>
        <translation>请先用“线段”选择节点。</translation>
    </message>
    <message>
        <source>Select segments, or the nodes at their ends, with Segments first.</source>
        <translation>请先用“线段”选择线段，或它们两端的节点。</translation>
    </message>
    <message>
        <source>Select two end nodes with Segments first.</source>
        <translation>请先用“线段”选择两个端点。</translation>
    </message>
    <message>
        <source>&amp;Show the Axes of the Symmetry</source>
        <translation>显示对称轴(&amp;S)</translation>
    </message>
    <message>
        <source>Also the square that moves them and the disc that turns them</source>
        <translation>也显示用于移动的方块和用于旋转的圆盘</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>参考线</translation>
    </message>
    <message>
        <source>Horizontal place</source>
        <translation>水平位置</translation>
    </message>
    <message>
        <source>Vertical place</source>
        <translation>垂直位置</translation>
    </message>
    <message>
        <source>Show the &amp;Rulers</source>
        <translation>显示标尺(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Along the upper and the left edge; guides are dragged out of them, and back into them</source>
        <translation>沿上边和左边；可从标尺拖出参考线，也可拖回</translation>
    </message>
    <message>
        <source>Show the &amp;Guides</source>
        <translation>显示参考线(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Snap to Guides</source>
        <translation>吸附到参考线(&amp;S)</translation>
    </message>
    <message>
        <source>Nodes, shapes and what is moved; paint goes where the hand goes</source>
        <translation>节点、形状和移动的内容会吸附；绘画则跟随手的动作</translation>
    </message>
    <message>
        <source>&amp;Lock the Guides</source>
        <translation>锁定参考线(&amp;L)</translation>
    </message>
    <message>
        <source>They cannot be dragged, and new ones still can be made</source>
        <translation>不能拖动参考线，但仍可新建</translation>
    </message>
    <message>
        <source>Add a Le&amp;vel Guide…</source>
        <translation>添加水平参考线(&amp;V)…</translation>
    </message>
    <message>
        <source>Add an &amp;Upright Guide…</source>
        <translation>添加垂直参考线(&amp;U)…</translation>
    </message>
    <message>
        <source>Remove &amp;All Guides</source>
        <translation>移除所有参考线(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;how the Assistants</source>
        <translation>显示辅助尺(&amp;H)</translation>
    </message>
    <message>
        <source>Nothing is led by those that are not seen</source>
        <translation>看不见的辅助尺不会引导笔画</translation>
    </message>
    <message>
        <source>&amp;Snap to Assistants</source>
        <translation>吸附到辅助尺(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>A stroke of the Brush follows the assistant whose direction it begins with</source>
        <translation>画笔的笔画会跟随与其起笔方向一致的辅助尺</translation>
    </message>
    <message>
        <source>Remove &amp;All Assistants</source>
        <translation>移除所有辅助尺(&amp;A)</translation>
    </message>
    <message>
        <source>There are no assistants.</source>
        <translation>没有辅助尺。</translation>
    </message>
    <message>
        <source>Assistants</source>
        <translation>辅助尺</translation>
    </message>
    <message>
        <source>Lines, vanishing points and ellipses that lead strokes</source>
        <translation>引导笔画的直线、灭点和椭圆</translation>
    </message>
    <message>
        <source>Mirrored &amp;Left and Right</source>
        <translation>左右镜像(&amp;L)</translation>
    </message>
    <message>
        <source>What is painted on one side of an upright axis comes on the other, too</source>
        <translation>在竖直轴一侧画的内容也会出现在另一侧</translation>
    </message>
    <message>
        <source>Mirrored &amp;Top and Bottom</source>
        <translation>上下镜像(&amp;T)</translation>
    </message>
    <message>
        <source>What is painted above a level axis comes below it, too</source>
        <translation>在水平轴上方画的内容也会出现在下方</translation>
    </message>
    <message>
        <source>Mirrored &amp;Both Ways</source>
        <translation>双向镜像(&amp;B)</translation>
    </message>
    <message>
        <source>What is painted comes in all four corners of a cross</source>
        <translation>画的内容会出现在十字的四个角落</translation>
    </message>
    <message>
        <source>&amp;Rotated around the Centre</source>
        <translation>绕中心旋转(&amp;R)</translation>
    </message>
    <message>
        <source>What is painted comes once in each arm around the centre</source>
        <translation>画的内容会在中心周围的每个臂中各出现一次</translation>
    </message>
    <message>
        <source>&amp;Kaleidoscope</source>
        <translation>万花筒(&amp;K)</translation>
    </message>
    <message>
        <source>What is painted comes in each arm around the centre, and mirrored beside it</source>
        <translation>画的内容会出现在中心周围的每个臂中，并在旁边出现其镜像</translation>
    </message>
    <message>
        <source>&amp;Paint in Symmetry</source>
        <translation>对称绘画(&amp;P)</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step</source>
        <translation>笔画、形状和轮廓会以镜像或旋转的方式出现多份，合为一个撤销步骤</translation>
    </message>
    <message>
        <source>Number of &amp;Arms…</source>
        <translation>臂数(&amp;A)…</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Arms around the centre</source>
        <translation>中心周围的臂</translation>
    </message>
    <message>
        <source>An&amp;gle of the Axes…</source>
        <translation>轴的角度(&amp;G)…</translation>
    </message>
    <message>
        <source>Degrees clockwise</source>
        <translation>顺时针度数</translation>
    </message>
    <message>
        <source>Axes to the &amp;Middle of the Canvas</source>
        <translation>轴移到画布中央(&amp;M)</translation>
    </message>
    <message>
        <source>The centre of the symmetry lies in the middle again, and the axes are upright and level</source>
        <translation>对称中心回到画布中央，轴恢复竖直和水平</translation>
    </message>
    <message>
        <source>Rulers and Guides</source>
        <translation>标尺和参考线</translation>
    </message>
    <message>
        <source>Workspace to &amp;Paint</source>
        <translation>绘画工作区(&amp;P)</translation>
    </message>
    <message>
        <source>Colour, brushes and strokes beside a wide canvas</source>
        <translation>宽阔的画布旁是颜色、画笔和笔画</translation>
    </message>
    <message>
        <source>Workspace to &amp;Refine</source>
        <translation>修整工作区(&amp;R)</translation>
    </message>
    <message>
        <source>Inspector, strokes, history and colour</source>
        <translation>检查器、笔画、历史记录和颜色</translation>
    </message>
    <message>
        <source>Workspace for &amp;Time</source>
        <translation>时间工作区(&amp;T)</translation>
    </message>
    <message>
        <source>A high timeline, with inspector and strokes</source>
        <translation>较高的时间轴，以及检查器和笔画</translation>
    </message>
    <message>
        <source>&amp;Save Workspace…</source>
        <translation>保存工作区(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep where docks and tool bars stand now, under a name</source>
        <translation>以一个名称保存面板和工具栏现在的位置</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>工作区</translation>
    </message>
    <message>
        <source>Rulers in &amp;Canvas Units</source>
        <translation>标尺以画布单位计(&amp;C)</translation>
    </message>
    <message>
        <source>Rulers in &amp;Millimetres</source>
        <translation>标尺以毫米计(&amp;M)</translation>
    </message>
    <message>
        <source>Rulers in &amp;Inches</source>
        <translation>标尺以英寸计(&amp;I)</translation>
    </message>
    <message>
        <source>New View</source>
        <translation>新建视图</translation>
    </message>
    <message>
        <source>A window that shows the painting from elsewhere while you paint; each edit shows in both</source>
        <translation>绘画时从别处显示画作的窗口；每次修改会同时显示在两个窗口中</translation>
    </message>
    <message>
        <source>&amp;Repeat Last Extension</source>
        <translation>重复上次的扩展(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+X</source>
        <translation>Ctrl+Alt+X</translation>
    </message>
    <message>
        <source>Once more, with the same values</source>
        <translation>用相同的值再运行一次</translation>
    </message>
    <message>
        <source>&amp;Manage Extensions…</source>
        <translation>管理扩展(&amp;M)…</translation>
    </message>
    <message>
        <source>Which extensions there are, which are in the menu, and what went wrong</source>
        <translation>有哪些扩展、哪些在菜单中、以及出了什么问题</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected.</source>
        <translation>没有选中可见且未锁定的内容。</translation>
    </message>
    <message>
        <source>E&amp;xtensions</source>
        <translation>扩展(&amp;X)</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Paint with Ke&amp;ys</source>
        <translation>用键盘绘画(&amp;Y)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it</source>
        <translation>方向键在画布上移动十字线，空格键按下和抬起当前工具</translation>
    </message>
    <message>
        <source>There are no guides.</source>
        <translation>没有参考线。</translation>
    </message>
    <message>
        <source>Choose a symmetry that turns, or the kaleidoscope, first.</source>
        <translation>请先选择旋转对称或万花筒。</translation>
    </message>
    <message>
        <source>No extension has run yet.</source>
        <translation>尚未运行过扩展。</translation>
    </message>
</context>
<context>
    <name>suffuse::CompareButton</name>
    <message>
        <source>Before</source>
        <translation>更改前</translation>
    </message>
    <message>
        <source>Shows the picture as it was before the last changes to the selection: while held, or click to switch back and forth.</source>
        <translation>显示上次更改所选内容之前的图像：按住时显示，或点击来回切换。</translation>
    </message>
</context>
<context>
    <name>suffuse::CrossSectionPlot</name>
    <message>
        <source>Not painted yet</source>
        <translation>尚未绘制</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>横截面</translation>
    </message>
    <message>
        <source>Covers up to %1</source>
        <translation>最高覆盖 %1</translation>
    </message>
</context>
<context>
    <name>suffuse::CurrentLayer</name>
    <message>
        <source>Layer: %1</source>
        <translation>图层：%1</translation>
    </message>
    <message>
        <source>No layer: paint goes on top of all</source>
        <translation>不用图层：颜料画在所有内容之上</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>图层 %1</translation>
    </message>
    <message>
        <source>New layer: %1. Paint on it.</source>
        <translation>新图层：%1。请在上面绘画。</translation>
    </message>
    <message>
        <source>New clipped layer: %1. Paint on it, where the layer below has paint.</source>
        <translation>新剪贴图层：%1。请在下方图层有颜料之处绘画。</translation>
    </message>
    <message>
        <source>All is shown again, since this would be hidden</source>
        <translation>已重新显示全部，否则新内容会被隐藏</translation>
    </message>
    <message>
        <source>%1 is locked: nothing is painted there</source>
        <translation>%1 已锁定：无法在其上绘画</translation>
    </message>
    <message>
        <source>%1 is hidden: nothing is painted there</source>
        <translation>%1 已隐藏：无法在其上绘画</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 副本</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 副本 %2</translation>
    </message>
    <message>
        <source>Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.</source>
        <translation>只能触及“%1”上的内容。“图层 ▸ 仅此图层”可恢复触及全部。</translation>
    </message>
</context>
<context>
    <name>suffuse::CurveEditor</name>
    <message>
        <source>along the stroke →</source>
        <translation>沿笔画 →</translation>
    </message>
</context>
<context>
    <name>suffuse::DensityPlot</name>
    <message>
        <source>Coverage at the peak density %1: %2 %</source>
        <translation>峰值密度 %1 处的覆盖率：%2 %</translation>
    </message>
    <message>
        <source>density φ — first of several styles</source>
        <translation>密度 φ — 多种样式中的第一种</translation>
    </message>
    <message>
        <source>density φ</source>
        <translation>密度 φ</translation>
    </message>
    <message>
        <source>F(φ), peak %1</source>
        <translation>F(φ)，峰值 %1</translation>
    </message>
</context>
<context>
    <name>suffuse::Docks</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>排列(&amp;A)</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>探查</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingTool</name>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>What was drawn encloses no area: nothing was added.</source>
        <translation>所画的线没有围成区域：未添加任何内容。</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Outline and fill</source>
        <translation>轮廓和填充</translation>
    </message>
    <message>
        <source>What of the shape is painted</source>
        <translation>绘制形状的哪一部分</translation>
    </message>
</context>
<context>
    <name>suffuse::Editor</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <extracomment>name of a document that was brought back after a crash</extracomment>
        <translation>%1（已恢复）</translation>
    </message>
    <message>
        <source>is damaged, so the painting stays as it is; save it, or open the file to see what is whole of it</source>
        <translation>已损坏，画作保持不变；请保存画作，或打开该文件查看其中完好的内容</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原到文件</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserFields</name>
    <message>
        <source>Fade</source>
        <translation>淡化</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>柔擦</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges draw in; Cut cuts curves out</source>
        <translation>“淡化”使一切可见的颜料变淡；“柔擦”减去其密度，使边缘内缩；“剪切”剪除曲线</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>How far what is taken away spreads, as a share of the radius</source>
        <translation>擦除的扩散范围，占半径的比例</translation>
    </message>
    <message>
        <source>Selected Strokes</source>
        <extracomment>scope of the eraser, while no stroke is selected</extracomment>
        <translation>所选笔画</translation>
    </message>
    <message>
        <source>Current Group</source>
        <translation>当前群组</translation>
    </message>
    <message>
        <source>All Strokes</source>
        <translation>所有笔画</translation>
    </message>
    <message>
        <source>From which strokes; without a selection, the first choice means all</source>
        <translation>从哪些笔画擦除；未选择时，第一项表示全部</translation>
    </message>
    <message>
        <source>All (None Selected)</source>
        <translation>全部（未选择）</translation>
    </message>
    <message>
        <source>Fade: the share of the paint that is taken. Lift: how much density, so that feathered paint gets paler and paint with a sharp edge narrower. A pen&apos;s pressure takes from it</source>
        <translation>淡化：擦去颜料的比例。柔擦：减去多少密度，使羽化的颜料变淡、边缘清晰的颜料变窄。画笔压力会减弱它</translation>
    </message>
    <message>
        <source>Sharp edges draw in.</source>
        <translation>清晰的边缘会内缩。</translation>
    </message>
</context>
<context>
    <name>suffuse::ErasureRows</name>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Fade makes paint paler; Lift takes its density away, so that edges draw in.</source>
        <translation>“淡化”使颜料变淡；“柔擦”减去其密度，使边缘内缩。</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>淡化</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>柔擦</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>The diameter of the eraser, if its softness was the usual one.</source>
        <translation>橡皮擦的直径（按其通常的柔和度）。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>The share of the paint that it takes in its middle.</source>
        <translation>它在其中央擦去颜料的比例。</translation>
    </message>
    <message>
        <source>Density taken</source>
        <translation>擦去的密度</translation>
    </message>
    <message>
        <source>Change size</source>
        <translation>更改大小</translation>
    </message>
    <message>
        <source>The density that it takes away in its middle: paint that is thinner is gone there.</source>
        <translation>在其中间擦去的密度：较稀的颜料在那里会消失。</translation>
    </message>
    <message>
        <source>Change strength</source>
        <translation>更改强度</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于全部所选内容：某个值会超出范围。</translation>
    </message>
    <message>
        <source>Change kind of erasure</source>
        <translation>更改擦除类型</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserTool</name>
    <message>
        <source>Erase</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>淡化：拖动使所选笔触按强度变淡。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>淡化：拖动使该群组的笔触按强度变淡。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>淡化：拖动使一切可见的颜料按强度变淡。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>柔擦：拖动以柔和地擦去所选笔画的颜料。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>柔擦：拖动以柔和地擦去该群组笔画的颜料。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>柔擦：拖动以柔和地擦去一切可见的颜料。Shift：剪切。[ 和 ] 改变大小，{ 和 } 改变强度。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>剪切：拖动以剪除所选曲线在圆下的部分。Shift：柔和擦除。[ 和 ] 改变大小。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the group&apos;s curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>剪切：拖动以剪除该群组曲线在圆下的部分。Shift：柔和擦除。[ 和 ] 改变大小。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>剪切：拖动以剪除曲线在圆下的部分。Shift：柔和擦除。[ 和 ] 改变大小。</translation>
    </message>
    <message>
        <source>Nothing is erased: no paint is seen under the circle.</source>
        <translation>未擦除任何内容：圆下没有可见的颜料。</translation>
    </message>
    <message>
        <source>Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.</source>
        <translation>未剪切任何内容：圆下没有曲线。“淡化”可擦去一切可见的颜料。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not selected.</source>
        <translation>未擦除任何内容：圆下的笔画未被选择。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is in another group.</source>
        <translation>未擦除任何内容：圆下的笔画属于另一个群组。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is locked.</source>
        <translation>未擦除任何内容：圆下的笔画已锁定。</translation>
    </message>
    <message>
        <source>It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes its paint away.</source>
        <translation>已切开，但几乎看不到缝隙：其边缘比切口宽度更柔和。“淡化”可擦去其颜料。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not on the layer, and only that is reached.</source>
        <translation>未擦除任何内容：圆圈下的内容不在此图层上，而只能触及此图层。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportDialog</name>
    <message>
        <source>8 bit</source>
        <translation>8 位</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 位</translation>
    </message>
    <message>
        <source>16 bit floating point</source>
        <translation>16 位浮点</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 位浮点</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers.</source>
        <translation>扩展名决定格式：png、tiff、exr、jpg、webp 或 pfm，或带图层的 ora 或 psd。</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>选择文件夹和文件名</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>位深</translation>
    </message>
    <message>
        <source>Precision of each colour channel</source>
        <translation>每个颜色通道的精度</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Of JPEG and WebP; 100 is the best. WebP loses nothing then.</source>
        <translation>用于 JPEG 和 WebP；100 为最佳，此时 WebP 无损。</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>透明背景</translation>
    </message>
    <message>
        <source>Leaves the background out and stores how much the paint covers.</source>
        <translation>去掉背景，并保存颜料的覆盖程度。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source> px</source>
        <translation> 像素</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>宽度（像素）</translation>
    </message>
    <message>
        <source>Width in pixels; the height follows.</source>
        <translation>宽度（像素）；高度随之变化。</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>高度（像素）</translation>
    </message>
    <message>
        <source>Height in pixels; the width follows.</source>
        <translation>高度（像素）；宽度随之变化。</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>画作</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>“%1” has no ending of a picture format. Choose one of: %2.</source>
        <translation>“%1”没有图片格式的扩展名。请选择其一：%2。</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 已存在。要替换吗？</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>其现有内容将丢失。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>At most %1 × %2 px</source>
        <translation>最大 %1 × %2 像素</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>No picture format</source>
        <translation>不是图像格式</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>What is written. The ending of the file&apos;s name says the same.</source>
        <translation>要写入的格式，与文件名的扩展名一致。</translation>
    </message>
    <message>
        <source>Pictures are written here. File ▸ Export Drawing writes SVG.</source>
        <translation>此处导出图片。SVG 由“文件 ▸ 导出图形”写入。</translation>
    </message>
    <message>
        <source>Photoshop (layers)</source>
        <translation>Photoshop（图层）</translation>
    </message>
    <message>
        <source>OpenRaster (layers)</source>
        <translation>OpenRaster（图层）</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>The colour profile that the file has. The painting keeps the one that was chosen from a file.</source>
        <translation>文件所用的颜色配置文件。绘画会保留从文件中选择的那一个。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportJob</name>
    <message>
        <source>A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.</source>
        <translation>内存放不下 %1 × %2 像素的图片。请选择较小的尺寸。</translation>
    </message>
</context>
<context>
    <name>suffuse::Exporting</name>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
    <message>
        <source>Printed to %1</source>
        <translation>已打印到 %1</translation>
    </message>
    <message>
        <source>Given to the printer %1</source>
        <translation>已交给打印机 %1</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>正在导出 %1…</translation>
    </message>
</context>
<context>
    <name>suffuse::EyedropperTool</name>
    <message>
        <source>Click to take the picture&apos;s colour as the current one. Shift: the stroke&apos;s own colour.</source>
        <translation>点击将画面的颜色取为当前颜色。Shift：取笔画本身的颜色。</translation>
    </message>
    <message>
        <source>A click takes</source>
        <translation>点击获取</translation>
    </message>
    <message>
        <source>The colour, to paint with</source>
        <translation>颜色，用于绘画</translation>
    </message>
    <message>
        <source>The appearance, for the selection</source>
        <translation>外观，用于所选</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>匹配</translation>
    </message>
    <message>
        <source>Select strokes first: they get the appearance of the stroke you click.</source>
        <translation>请先选择笔画：它们将获得所点击笔画的外观。</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its appearance, and what varies along them stays. Shift: the same values all along.</source>
        <translation>点击笔画：所选笔画获得其外观，沿笔画的变化保留。Shift：全程使用相同的值。</translation>
    </message>
    <message>
        <source>Click to give what is selected the picture&apos;s colour. Shift: the stroke&apos;s own colour. Ctrl: its whole appearance.</source>
        <translation>点击将画面颜色赋予所选内容。Shift：笔画自身的颜色。Ctrl：笔画的全部外观。</translation>
    </message>
    <message>
        <source>Click to give the swatch the picture&apos;s colour. Shift: the stroke&apos;s own colour.</source>
        <translation>点击将画面颜色赋予色板。Shift：笔画自身的颜色。</translation>
    </message>
    <message>
        <source>A colour, or style, values and colour of a stroke for the selected ones. The colour is for what the Colour dock shows: the brush, the selection or a swatch.</source>
        <translation>取一种颜色，或将某笔画的样式、数值和颜色用于所选笔画。颜色用于颜色面板当前所示的对象：画笔、所选内容或色板。</translation>
    </message>
    <message>
        <source>The colour, for the selection</source>
        <translation>颜色，用于所选</translation>
    </message>
    <message>
        <source>The colour, for the swatch</source>
        <translation>颜色，用于色板</translation>
    </message>
</context>
<context>
    <name>suffuse::FiguresSection</name>
    <message>
        <source>The outline lays no paint: its density φ is 0. What is seen is the fill.</source>
        <translation>轮廓没有颜料：其密度 φ 为 0。可见的是填充。</translation>
    </message>
    <message>
        <source>Density function</source>
        <translation>密度函数</translation>
    </message>
    <message>
        <source>How density becomes coverage. The mark is the peak density of the selected segments.</source>
        <translation>密度如何转化为覆盖率。标记处为所选线段的峰值密度。</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>横截面</translation>
    </message>
    <message>
        <source>The cut through the stroke at the first selected segment, at the moment shown: coverage, on the colour that it has on the background.</source>
        <translation>在第一条所选线段处、当前所示时刻横切笔画的截面：显示覆盖率，并以其在背景上呈现的颜色绘制。</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Spread s</source>
        <translation>扩散距离 s</translation>
    </message>
    <message>
        <source>Peak density</source>
        <translation>峰值密度</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>半宽</translation>
    </message>
    <message>
        <source>Fades away</source>
        <translation>消褪</translation>
    </message>
    <message>
        <source>Density in the middle of a long straight stroke, dry.</source>
        <translation>干透的长直笔画中央的密度。</translation>
    </message>
    <message>
        <source>From the middle to the visible edge of a long straight stroke, dry.</source>
        <translation>干透的长直笔画从中央到可见边缘的距离。</translation>
    </message>
    <message>
        <source>When the paint has spread so thin that nothing of it is visible any more.</source>
        <translation>颜料扩散到稀薄得完全看不见的时间。</translation>
    </message>
    <message>
        <source>never</source>
        <translation>不会</translation>
    </message>
    <message>
        <source>partly, from %1</source>
        <translation>部分，自 %1 起</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>%1 后</translation>
    </message>
    <message>
        <source>Spread along</source>
        <translation>纵向扩散</translation>
    </message>
    <message>
        <source>How far the paint has spread across the curve once it is dry: √(4·D·t_max).</source>
        <translation>颜料干透时垂直于曲线扩散的距离：√(4·D·t_max)。</translation>
    </message>
    <message>
        <source>How far it has spread along the curve.</source>
        <translation>沿曲线扩散的距离。</translation>
    </message>
    <message>
        <source>Spread across</source>
        <translation>横向扩散</translation>
    </message>
    <message>
        <source>Takes away</source>
        <translation>擦去量</translation>
    </message>
    <message>
        <source>How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max).</source>
        <translation>擦除边缘的柔和程度：它在曲线旁扩散的距离，√(4·D·t_max)。</translation>
    </message>
    <message>
        <source>What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if it lifts, and paint that is thinner is gone there.</source>
        <translation>擦除的一个线段在其中央擦去的量：淡化时为颜料的比例；柔擦时为密度，比它更薄的颜料在那里完全消失。</translation>
    </message>
</context>
<context>
    <name>suffuse::FileOpening</name>
    <message>
        <source>Pictures with layers (*.ora *.psd)</source>
        <translation>带图层的图片 (*.ora *.psd)</translation>
    </message>
    <message>
        <source>All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</source>
        <translation>所有可打开的文件 (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</translation>
    </message>
    <message>
        <source>Suffuse paintings (*.suffuse *.json)</source>
        <translation>Suffuse 画作 (*.suffuse *.json)</translation>
    </message>
    <message>
        <source>Backups of paintings (*.suffuse~* *.json~*)</source>
        <translation>画作的备份 (*.suffuse~* *.json~*)</translation>
    </message>
    <message>
        <source>Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</source>
        <translation>笔迹记录 (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</translation>
    </message>
    <message>
        <source>Drawings (*.svg *.svgz *.pdf)</source>
        <translation>图形 (*.svg *.svgz *.pdf)</translation>
    </message>
    <message>
        <source>Diffusion curves (*.xml)</source>
        <translation>扩散曲线 (*.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>“%1” is open already.</source>
        <translation>“%1”已经打开。</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was opened; the file itself is left as it is.</source>
        <translation>“%1”已损坏。已打开其完好的部分；文件本身保持原样。</translation>
    </message>
    <message>
        <source>&amp;Clear the List</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::FileRestoring</name>
    <message>
        <source>Revert “%1” to what the file holds?</source>
        <translation>要将“%1”还原为文件中的内容吗？</translation>
    </message>
    <message>
        <source>What was painted since the last save goes; Undo brings it back.</source>
        <translation>上次保存以来绘制的内容将被去掉；撤销可将其恢复。</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>还原(&amp;R)</translation>
    </message>
    <message>
        <source>Restore backup of %1</source>
        <translation>恢复 %1 的备份</translation>
    </message>
    <message>
        <source>The backup of %1 is back. Undo takes it away again; no file changes until you save.</source>
        <translation>%1 的备份已恢复。可以撤销；保存之前不会改动任何文件。</translation>
    </message>
    <message>
        <source>The backup of %1 is what you see: nothing has changed.</source>
        <translation>%1 的备份与当前画面相同：没有任何改动。</translation>
    </message>
    <message>
        <source>The backup is damaged. What is whole of it was restored.</source>
        <translation>备份已损坏。其中完好的内容已恢复。</translation>
    </message>
</context>
<context>
    <name>suffuse::FileSaving</name>
    <message>
        <source>What you paint now would not survive a crash: %1. Painting goes on; save from time to time.</source>
        <translation>现在绘制的内容在崩溃后将无法恢复：%1。可以继续绘画；请不时保存。</translation>
    </message>
    <message>
        <source>“%1” is gone from its folder. Save to put it back.</source>
        <translation>“%1”已不在其文件夹中。保存即可放回。</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>name of the file that a copy is saved to, beside that of the painting</extracomment>
        <translation>%1 副本</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>保存副本</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>正在保存“%1”…</translation>
    </message>
    <message>
        <source>A copy is saved as “%1”.</source>
        <translation>副本已保存为“%1”。</translation>
    </message>
    <message>
        <source>“%1” is saved already.</source>
        <translation>“%1”已是保存过的状态。</translation>
    </message>
    <message>
        <source>%1 (without what is still being drawn)</source>
        <translation>%1（不含仍在绘制的内容）</translation>
    </message>
    <message>
        <source>Saved “%1”, %2</source>
        <translation>已保存“%1”，%2</translation>
    </message>
    <message>
        <source>Saved “%1”, but %2</source>
        <translation>已保存“%1”，但 %2</translation>
    </message>
    <message>
        <source>“%1” is not saved.</source>
        <translation>“%1”未保存。</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse 画作</translation>
    </message>
    <message>
        <source>Text form</source>
        <translation>文本形式</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Choose another name, or close that window first.</source>
        <translation>“%1”已在另一个窗口中打开。请换个名称，或先关闭那个窗口。</translation>
    </message>
    <message>
        <source>“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.</source>
        <translation>“%1”包含简单的线条和区域，供其他程序使用。“导出图形”可保留柔边和深色边缘。</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG 图形</translation>
    </message>
</context>
<context>
    <name>suffuse::FileTypes</name>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse 画作</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse 画笔</translation>
    </message>
    <message>
        <source>Backup of a painting</source>
        <translation>画作的备份</translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>%n 个调整或填充图层</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>%n 个图层的效果</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>%n 个组的蒙版</numerusform>
        </translation>
    </message>
    <message>
        <source>This Photoshop file is damaged.</source>
        <translation>此 Photoshop 文件已损坏。</translation>
    </message>
    <message>
        <source>Photoshop picture</source>
        <translation>Photoshop 图片</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.</source>
        <translation>不读取每边超过 30,000 像素的 Photoshop 文件 (PSB)。请另存为 PSD。</translation>
    </message>
    <message>
        <source>Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.</source>
        <translation>只读取 8 位或 16 位的 RGB 或灰度 Photoshop 文件。请将其转换为 RGB。</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>%n 个图层(其图片缺失、损坏或过大)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>%n 个图层的混合模式</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: %1.</source>
        <translation>此 OpenRaster 文件已损坏:%1。</translation>
    </message>
    <message>
        <source>it has no list of its layers</source>
        <translation>缺少图层目录</translation>
    </message>
    <message>
        <source>its list of layers cannot be read</source>
        <translation>无法读取图层目录</translation>
    </message>
    <message>
        <source>is a folder; give a file name inside it</source>
        <translation>是文件夹；请给出其中的文件名</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file; save to a file</source>
        <translation>是设备或管道而不是文件；请保存到文件</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; create it or choose another one</source>
        <translation>文件夹 %1 不存在；请创建它或选择其他文件夹</translation>
    </message>
    <message>
        <source>%1 is not a folder; choose another place</source>
        <translation>%1 不是文件夹；请选择其他位置</translation>
    </message>
    <message>
        <source>the folder %1 is read-only; choose another one or change its permissions</source>
        <translation>文件夹 %1 为只读；请选择其他文件夹或更改其权限</translation>
    </message>
    <message>
        <source>The file has no name; choose one</source>
        <translation>文件没有名称；请指定一个</translation>
    </message>
    <message>
        <source>would have more than 2 GB; nothing was written</source>
        <translation>将超过 2 GB；未写入任何内容</translation>
    </message>
    <message>
        <source>cannot be written (%1); choose another place</source>
        <translation>无法写入（%1）；请选择其他位置</translation>
    </message>
    <message>
        <source>%1 (%2); the old file, if there was one, is as before. Free some space or choose another place</source>
        <translation>%1（%2）；原有文件（如有）保持不变。请释放空间或选择其他位置</translation>
    </message>
    <message>
        <source>could not be written in full</source>
        <translation>未能完整写入</translation>
    </message>
    <message>
        <source>could not be put in place</source>
        <translation>未能放到目标位置</translation>
    </message>
    <message>
        <source>was written, but the folder could not be brought to the disk (%1); save once more before you switch off</source>
        <translation>已写入，但文件夹未能同步到磁盘（%1）；关机前请再保存一次</translation>
    </message>
    <message>
        <source>the image has %1 MB; at most 64 MB are possible, make it smaller</source>
        <translation>图像有 %1 MB；最多 64 MB，请缩小</translation>
    </message>
    <message>
        <source>is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them</source>
        <translation>不是 PNG、JPEG、TIFF、WebP 或 EXR 图像；请转换为其中之一</translation>
    </message>
    <message>
        <source>is empty; give a data: URL or the path of an image file</source>
        <translation>为空；请给出 data: URL 或图像文件的路径</translation>
    </message>
    <message>
        <source>the image file %1 is missing; put it there or correct the path</source>
        <translation>图像文件 %1 不存在；请放到该处或更正路径</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 不是文件</translation>
    </message>
    <message>
        <source>the image file %1 has %2 MB; at most 64 MB are possible</source>
        <translation>图像文件 %1 有 %2 MB；最多 64 MB</translation>
    </message>
    <message>
        <source>the image file %1 cannot be read: %2</source>
        <translation>无法读取图像文件 %1：%2</translation>
    </message>
    <message>
        <source>is not a data:…;base64,… URL</source>
        <translation>不是 data:…;base64,… URL</translation>
    </message>
    <message>
        <source>the image is too large; at most 64 MB are possible</source>
        <translation>图像太大；最多 64 MB</translation>
    </message>
    <message>
        <source>the base64 data of the image are damaged</source>
        <translation>图像的 base64 数据已损坏</translation>
    </message>
    <message>
        <source>has more than 2 GB; that is more than can be opened</source>
        <translation>超过 2 GB，无法打开</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse 画作</translation>
    </message>
    <message>
        <source>Suffuse text form</source>
        <translation>Suffuse 文本形式</translation>
    </message>
    <message>
        <source>Ink recording (CSV)</source>
        <translation>笔迹记录 (CSV)</translation>
    </message>
    <message>
        <source>Universal Ink</source>
        <translation>Universal Ink</translation>
    </message>
    <message>
        <source>Excalidraw drawing</source>
        <translation>Excalidraw 绘图</translation>
    </message>
    <message>
        <source>MyPaint events</source>
        <translation>MyPaint 事件</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>未知格式</translation>
    </message>
    <message>
        <source>there is no such file: %1</source>
        <translation>没有此文件：%1</translation>
    </message>
    <message>
        <source>is a folder; give a file inside it</source>
        <translation>是文件夹；请给出其中的文件</translation>
    </message>
    <message>
        <source>could not be opened: %1; check its permissions</source>
        <translation>无法打开：%1；请检查其权限</translation>
    </message>
    <message>
        <source>the ending is neither .suffuse nor .json; choose one of them</source>
        <translation>扩展名既不是 .suffuse 也不是 .json；请选择其一</translation>
    </message>
    <message>
        <source>%1: has less than 2 numbers</source>
        <translation>%1：少于 2 个数字</translation>
    </message>
    <message>
        <source>holds no freedraw elements; only those become strokes</source>
        <translation>不含自由绘制元素；只有这类元素能成为笔画</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>: is not a list of numbers</source>
        <translation>：不是数字列表</translation>
    </message>
    <message>
        <source>%1[%2]: is not a number within ±1e15</source>
        <translation>%1[%2]：不是 ±1e15 以内的数字</translation>
    </message>
    <message>
        <source>line %1, column %2: “%3” is not a number within ±1e15</source>
        <translation>第 %1 行第 %2 列：“%3”不是 ±1e15 以内的数字</translation>
    </message>
    <message>
        <source>is empty; there is nothing to paint</source>
        <translation>为空；没有可绘制的内容</translation>
    </message>
    <message>
        <source>line %1: no columns x and y; name the columns x, y, time and pressure</source>
        <translation>第 %1 行：没有 x 和 y 列；请将列命名为 x、y、time 和 pressure</translation>
    </message>
    <message>
        <source>%1: splineX has %2 numbers, splineY %3</source>
        <translation>%1：splineX 有 %2 个数字，splineY 有 %3 个</translation>
    </message>
    <message>
        <source>an object {…}</source>
        <translation>对象 {…}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>列表 […]</translation>
    </message>
    <message>
        <source>the file ends here, “%1” is missing; it is probably cut off</source>
        <translation>文件在此结束，缺少“%1”；可能已被截断</translation>
    </message>
    <message>
        <source>expected “,” or “%1” before “%2”</source>
        <translation>“%2”之前应为“,”或“%1”</translation>
    </message>
    <message>
        <source>expected a member&apos;s name in quotes before “%1”</source>
        <translation>“%1”之前应为带引号的成员名</translation>
    </message>
    <message>
        <source>expected “:” after “%1”</source>
        <translation>“%1”之后应为“:”</translation>
    </message>
    <message>
        <source>is given twice; keep one of them</source>
        <translation>重复给出；请只保留一个</translation>
    </message>
    <message>
        <source>is not a member of this format; correct or remove it</source>
        <translation>不是此格式的成员；请更正或删除</translation>
    </message>
    <message>
        <source>a string has a wrong escape “\%1”</source>
        <translation>字符串含有错误的转义“\%1”</translation>
    </message>
    <message>
        <source>the file ends inside a string; it is probably cut off</source>
        <translation>文件在字符串中结束；可能已被截断</translation>
    </message>
    <message>
        <source>a string has a control character; write it as an escape such as \n</source>
        <translation>字符串含有控制字符；请写成 \n 之类的转义</translation>
    </message>
    <message>
        <source>the file ends here; it is probably cut off</source>
        <translation>文件在此结束；可能已被截断</translation>
    </message>
    <message>
        <source>expected %1 before “%2”</source>
        <translation>“%2”之前应为%1</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 不是%2</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>有 %1 个数字，应为 %2 个</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>%1 is too large; the largest number is %2</source>
        <translation>%1 太大；最大为 %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^64 − 1</source>
        <translation>%1 不是 0 到 2^64 − 1 的整数</translation>
    </message>
    <message>
        <source>%1 s is not in [-1e12, 1e12]</source>
        <translation>%1 秒不在 [-1e12, 1e12] 内</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>带引号的字符串</translation>
    </message>
    <message>
        <source>is not UTF-8; save the file in that encoding</source>
        <translation>不是 UTF-8；请以该编码保存文件</translation>
    </message>
    <message>
        <source>“%1” follows after the end of the painting; remove it</source>
        <translation>画作结束后还有“%1”；请删除</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>第 %1 行第 %2 列：%3</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>标准输入</translation>
    </message>
    <message>
        <source>holds no pen strokes; there is nothing to paint</source>
        <translation>不含笔画；没有可绘制的内容</translation>
    </message>
    <message>
        <source>the strokes span %1 × %2 units; at most 1e6 are possible, scale them down</source>
        <translation>笔画跨度为 %1 × %2 单位；最多 1e6，请缩小</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行第 %2 列</translation>
    </message>
    <message>
        <source>a value has the wrong type</source>
        <translation>某个值的类型不正确</translation>
    </message>
    <message>
        <source>the first chunk must be HEAD</source>
        <translation>第一个数据块必须是 HEAD</translation>
    </message>
    <message>
        <source>there is more than one HEAD</source>
        <translation>HEAD 多于一个</translation>
    </message>
    <message>
        <source>there is more than one</source>
        <translation>多于一个</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse</source>
        <translation>字节 %2 处的数据块 %1 未知，而画作需要它；请更新 Suffuse</translation>
    </message>
    <message>
        <source>is not a CBOR map</source>
        <translation>不是 CBOR 映射</translation>
    </message>
    <message>
        <source>lacks the version or the counts</source>
        <translation>缺少版本或计数</translation>
    </message>
    <message>
        <source>was written by a newer program (%1): it needs a reader of version %2, this one is %3; update Suffuse</source>
        <translation>由较新的程序写成（%1）：需要版本 %2 的读取器，当前为 %3；请更新 Suffuse</translation>
    </message>
    <message>
        <source>the chunk DOCU is missing; the file is damaged, take a backup copy</source>
        <translation>缺少数据块 DOCU；文件已损坏，请使用备份</translation>
    </message>
    <message>
        <source>should hold %1 strokes and %2 segments, but holds %3 and %4; the file is damaged, take a backup copy</source>
        <translation>应有 %1 条笔画和 %2 条线段，实际为 %3 和 %4；文件已损坏，请使用备份</translation>
    </message>
    <message>
        <source>the file is damaged, take a backup copy</source>
        <translation>文件已损坏，请使用备份</translation>
    </message>
    <message>
        <source>is not a .suffuse file</source>
        <translation>不是 .suffuse 文件</translation>
    </message>
    <message>
        <source>the hash of the whole differs</source>
        <translation>整体哈希值不符</translation>
    </message>
    <message>
        <source>%1 bytes follow after the end</source>
        <translation>结束后还有 %1 字节</translation>
    </message>
    <message>
        <source>has %1 bytes, but the file only %2 more</source>
        <translation>有 %1 字节，但文件只剩 %2 字节</translation>
    </message>
    <message>
        <source>checksum differs</source>
        <translation>校验和不符</translation>
    </message>
    <message>
        <source>%1 strokes and %2 segments are more than the file can hold</source>
        <translation>%1 条笔画和 %2 条线段超出文件的容量</translation>
    </message>
    <message>
        <source>its columns are not what the format allows</source>
        <translation>其数据列不符合格式</translation>
    </message>
    <message>
        <source>stroke %1 of it is not what the format allows</source>
        <translation>其中的笔画 %1 不符合格式</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>“%1” is none of: %2</source>
        <translation>“%1”不是以下之一：%2</translation>
    </message>
    <message>
        <source>has %1 numbers; the kind %2 has %3</source>
        <translation>有 %1 个数字；类型 %2 应有 %3 个</translation>
    </message>
    <message>
        <source>belongs to the mode beta; remove it or change the mode</source>
        <translation>属于 beta 模式；请删除或更改模式</translation>
    </message>
    <message>
        <source>has %1 points instead of 4</source>
        <translation>有 %1 个点，应为 4 个</translation>
    </message>
    <message>
        <source>has %1 numbers instead of 2</source>
        <translation>有 %1 个数字，应为 2 个</translation>
    </message>
    <message>
        <source>0 is not an id; count from 1 or leave it out</source>
        <translation>0 不是有效的 id；请从 1 开始或省略</translation>
    </message>
    <message>
        <source>%1 is not in [0, 4294967295]</source>
        <translation>%1 不在 [0, 4294967295] 内</translation>
    </message>
    <message>
        <source>width and height must not be negative</source>
        <translation>宽度和高度不能为负</translation>
    </message>
    <message>
        <source>%1 is not in [0, 1]</source>
        <translation>%1 不在 [0, 1] 内</translation>
    </message>
    <message>
        <source>“%1” is not “suffuse-text”</source>
        <translation>“%1”不是“suffuse-text”</translation>
    </message>
    <message>
        <source>0 is not a version; write 1</source>
        <translation>0 不是有效版本；请写 1</translation>
    </message>
    <message>
        <source>%1 is not a version that this program reads; it reads 1</source>
        <translation>%1 不是此程序可读取的版本；可读取的是 1</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input; keep one of them</source>
        <translation>另一条曲线有相同的参数和输入；请只保留一条</translation>
    </message>
    <message>
        <source>needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>需要 2 到 16 个位于 [0, 1] 内的点 [x, y]，从左到右</translation>
    </message>
    <message>
        <source>could not be opened: %1</source>
        <translation>无法打开：%1</translation>
    </message>
    <message>
        <source>has more than 1 MB; it is not a brush</source>
        <translation>超过 1 MB，不是画笔</translation>
    </message>
    <message>
        <source>a colour has three numbers: red, green, blue</source>
        <translation>一种颜色有三个数字：红、绿、蓝</translation>
    </message>
    <message>
        <source>“%1” is not a number from 0 to 255</source>
        <translation>“%1”不是 0 到 255 的数字</translation>
    </message>
    <message>
        <source>is larger than 1 MiB; a palette is not</source>
        <translation>大于 1 MiB，不会是调色板</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>“GIMP Palette” is missing: this is no GIMP palette</source>
        <translation>缺少“GIMP Palette”：这不是 GIMP 调色板</translation>
    </message>
    <message>
        <source>there are more than %1 colours</source>
        <translation>颜色超过 %1 种</translation>
    </message>
    <message>
        <source>has no settings; it is not a brush</source>
        <translation>没有设置，不是画笔</translation>
    </message>
    <message>
        <source>is write-protected; save under another name or change its permissions</source>
        <translation>受写保护；请以其他名称保存或更改其权限</translation>
    </message>
    <message>
        <source>belongs to %1, and would not any more; save under another name</source>
        <translation>属于 %1，保存后将不再属于该用户；请以其他名称保存</translation>
    </message>
    <message>
        <source>could not be brought to the disk</source>
        <translation>无法写到磁盘</translation>
    </message>
    <message>
        <source>the backup could not be made; check the folder</source>
        <translation>无法创建备份；请检查文件夹</translation>
    </message>
    <message>
        <source>the first element is not curve_set</source>
        <translation>第一个元素不是 curve_set</translation>
    </message>
    <message>
        <source>%1 of %2 is &quot;%3&quot;, not a number up to 1e6</source>
        <translation>%2 的 %1 为“%3”，不是不超过 1e6 的数</translation>
    </message>
    <message>
        <source>a curve has %1 control points; 3n + 1 make cubics</source>
        <translation>一条曲线有 %1 个控制点；三次曲线需要 3n + 1 个</translation>
    </message>
    <message>
        <source>a curve has no colours on one of its sides</source>
        <translation>一条曲线有一侧没有颜色</translation>
    </message>
    <message>
        <source>has more than 64 MB of XML; that is more than is read</source>
        <translation>含有超过 64 MB 的 XML；超出可读取的大小</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to paint</source>
        <translation>不含曲线；没有可绘制的内容</translation>
    </message>
    <message>
        <source>Diffusion curves (XML)</source>
        <translation>扩散曲线（XML）</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>它已损坏</translation>
    </message>
    <message>
        <source>it belongs to another painting</source>
        <translation>它属于另一幅画作</translation>
    </message>
    <message>
        <source>it has too many steps</source>
        <translation>它的步骤太多</translation>
    </message>
    <message>
        <source>step %1 is damaged</source>
        <translation>第 %1 步已损坏</translation>
    </message>
    <message>
        <source>step %1 does not fit the painting</source>
        <translation>第 %1 步与画作不符</translation>
    </message>
    <message>
        <source>the undo history was left out: %1</source>
        <translation>未载入撤销历史：%1</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2: %3</source>
        <translation>数据块 %1（位于字节 %2）：%3</translation>
    </message>
    <message>
        <source>is cut off after %1 bytes</source>
        <translation>在 %1 字节后被截断</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>字节 %1：%2</translation>
    </message>
    <message>
        <source>is damaged, and nothing in it is whole (%1); take a backup copy</source>
        <translation>已损坏，其中没有完好的内容（%1）；请使用备份</translation>
    </message>
    <message>
        <source>the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one</source>
        <translation>缺少画布、纸张、组、色板和底图；现使用默认画布</translation>
    </message>
    <message>
        <source>the image of the paper is missing; there is no paper now</source>
        <translation>缺少纸张图像；现在没有纸张</translation>
    </message>
    <message>
        <source>the underlay is missing</source>
        <translation>缺少底图</translation>
    </message>
    <message>
        <source>%1 strokes with %2 segments are here; how many there were is not known</source>
        <translation>现有 %1 笔、%2 段；原来有多少不得而知</translation>
    </message>
    <message>
        <source>%1 of %2 strokes are missing, with %3 of %4 segments</source>
        <translation>缺少 %2 笔中的 %1 笔，%4 段中的 %3 段</translation>
    </message>
    <message>
        <source>all %1 strokes are here</source>
        <translation>%1 笔全部完好</translation>
    </message>
    <message>
        <source>%1 strokes are in no group any more</source>
        <translation>%1 笔不再属于任何组</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>缺少文件的结尾</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>无法写入日志（%1）</translation>
    </message>
    <message>
        <source>is not a journal of Suffuse</source>
        <translation>不是 Suffuse 的日志</translation>
    </message>
    <message>
        <source>ends before its first painting was written</source>
        <translation>在写完首个画作之前结束</translation>
    </message>
    <message>
        <source>was written by a newer program (%1); update Suffuse</source>
        <translation>由更新的程序（%1）写成；请更新 Suffuse</translation>
    </message>
    <message>
        <source>Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)</source>
        <translation>Suffuse 可读取 .suffuse 及其文本形式（.json）、CSV 笔迹、Universal Ink、InkML、Excalidraw、MyPaint 事件、Xournal++、Rnote、SVG 和扩散曲线（XML）</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG 图形</translation>
    </message>
    <message>
        <source>the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down</source>
        <translation>图形大小为 %1 × %2 单位；最多 1e6，请缩小</translation>
    </message>
    <message>
        <source>holds no paths that can be painted; in the program that drew it, turn text and images into paths first</source>
        <translation>没有可绘制的路径；请先在原程序中将文字和图像转换为路径</translation>
    </message>
    <message>
        <source>the preview</source>
        <translation>预览图</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>上次查看的视图</translation>
    </message>
    <message>
        <source>the undo history</source>
        <translation>撤销历史</translation>
    </message>
    <message>
        <source>the end of the file is damaged</source>
        <translation>文件末尾已损坏</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at byte %1</source>
        <translation>文件在第 %1 字节处损坏或被截断</translation>
    </message>
    <message>
        <source>Damaged and left out: %1. All %2 strokes are here.</source>
        <translation>已损坏并略去：%1。全部 %2 条笔画都在。</translation>
    </message>
    <message>
        <source>damaged and left out: %1</source>
        <translation>已损坏并略去：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>%n 个非手绘元素</numerusform>
        </translation>
    </message>
    <message>
        <source>column “%1”</source>
        <translation>列“%1”</translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>%n 个笔刷形状</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>%n 个旋转或拉伸的笔尖</numerusform>
        </translation>
    </message>
    <message>
        <source>the pen&apos;s azimuths</source>
        <translation>笔的方位角</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>%n 个识别文字视图</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>已略去：%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>list</comment>
        <translation>、</translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>%n 个渐变</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>%n 个图案</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>%n 个剪切路径</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>%n 个蒙版</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>%n 个滤镜</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>%n 个混合模式</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>%n 个过于复杂的轮廓</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n 处文字</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n 张图像</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>%n 条样式规则</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>%n 个引用自身的 &lt;use&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>There is more in the drawing than is read; the rest was left out.</source>
        <translation>图形的内容超出可读取的范围；其余部分已略去。</translation>
    </message>
    <message>
        <source>ends after %1 bytes</source>
        <translation>在 %1 字节后结束</translation>
    </message>
    <message>
        <source>its line endings were changed on the way, transfer it as a binary file</source>
        <translation>其换行符在传输中被更改，请以二进制方式传输</translation>
    </message>
    <message>
        <source>its first bytes are damaged</source>
        <translation>其开头的字节已损坏</translation>
    </message>
    <message>
        <source>the first bytes of the file</source>
        <translation>文件开头的字节</translation>
    </message>
    <message>
        <source>version: %1 does not know all that strokes have here; write %2</source>
        <translation>version：%1 不认识此处笔触的全部内容；请写 %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads up to version %2; update Suffuse</source>
        <translation>%1 比此程序新（此程序最高读取版本 %2）；请更新 Suffuse</translation>
    </message>
    <message>
        <source>This file is empty: nothing was saved in it.</source>
        <translation>此文件为空：其中没有保存任何内容。</translation>
    </message>
    <message>
        <source>This is UTF-16 text. Save it as UTF-8.</source>
        <translation>这是 UTF-16 文本。请保存为 UTF-8。</translation>
    </message>
    <message>
        <source>This is a picture, not a painting. %1.</source>
        <translation>这是图片而不是画作。%1。</translation>
    </message>
    <message>
        <source>This is neither a painting nor a recording that can be read. %1. Other programs can export SVG.</source>
        <translation>这既不是画作，也不是可以读取的笔迹记录。%1。其他程序可以导出 SVG。</translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>%n 处填充</numerusform>
        </translation>
    </message>
    <message>
        <source>Other fonts stand in for those that are not installed: %1.</source>
        <translation>未安装的字体由其他字体代替：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>%n 段文字作为字母导入：无法再次键入。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>缺少 %n 个图像图层的图像</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: it has no list of its parts.</source>
        <translation>此 OpenRaster 文件已损坏：缺少各部分的目录。</translation>
    </message>
    <message>
        <source>OpenRaster picture</source>
        <translation>OpenRaster 图片</translation>
    </message>
    <message>
        <source>Another program changed this picture. What was opened is the painting as Suffuse exported it.</source>
        <translation>其他程序修改过此图片。打开的是 Suffuse 导出时的画作。</translation>
    </message>
    <message>
        <source>The linked picture %1 is missing, and is not seen: put its file back, or link another one in the Inspector.</source>
        <translation>链接的图片 %1 不存在，因此不可见：请放回其文件，或在检查器中链接其他文件。</translation>
    </message>
    <message>
        <source>The linked picture %1 has more than 64 MB, and is not seen.</source>
        <translation>链接的图片 %1 超过 64 MB，因此不可见。</translation>
    </message>
    <message>
        <source>The linked picture %1 has changed since it was linked, and is not seen: link it anew in the Inspector.</source>
        <translation>链接的图片 %1 在链接后已更改，因此不可见：请在检查器中重新链接。</translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>另外 %n 幅图片也是如此。</numerusform>
        </translation>
    </message>
    <message>
        <source>This file is compressed with gzip, and what is in it is neither an SVG nor a notebook of Xournal++ or Rnote. Unpack it first. %1.</source>
        <translation>此文件用 gzip 压缩，其中的内容既不是 SVG，也不是 Xournal++ 或 Rnote 笔记。请先解压。%1。</translation>
    </message>
    <message>
        <source>Another program has changed the drawing since Suffuse wrote it. It is opened as it is drawn now, not as the painting that is in it.</source>
        <translation>Suffuse 写出此图形后，其他程序更改了它。现在按图形目前的样子打开，而不是打开其中包含的画作。</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>is too large once it is unpacked</source>
        <translation>解压后过大</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>已损坏：无法解压</translation>
    </message>
    <message>
        <source>the colour profile</source>
        <translation>颜色配置文件</translation>
    </message>
    <message>
        <source>the size on paper</source>
        <translation>纸上大小</translation>
    </message>
    <message>
        <source>the first element is not xournal</source>
        <translation>第一个元素不是 xournal</translation>
    </message>
    <message>
        <source>holds no pages</source>
        <translation>不含任何页面</translation>
    </message>
    <message>
        <source>%1 is no number within ±1e7</source>
        <translation>%1 不是 ±1e7 以内的数字</translation>
    </message>
    <message>
        <source>has more than %1 layers</source>
        <translation>图层超过 %1 个</translation>
    </message>
    <message>
        <source>the page has no size</source>
        <translation>页面没有尺寸</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>图层 %1</translation>
    </message>
    <message>
        <source>the stroke has an x without y</source>
        <translation>笔画中有 x 而缺少 y</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>点数超过 %1 个</translation>
    </message>
    <message>
        <source>the stroke has no width</source>
        <translation>笔画没有宽度</translation>
    </message>
    <message>
        <source>%1: %2 is no number within ±1e7</source>
        <translation>%1：%2 不是 ±1e7 以内的数字</translation>
    </message>
    <message>
        <source>Xournal++ notebook</source>
        <translation>Xournal++ 笔记</translation>
    </message>
    <message>
        <source>InkML recording</source>
        <translation>InkML 笔迹</translation>
    </message>
    <message>
        <source>Rnote notebook</source>
        <translation>Rnote 笔记</translation>
    </message>
    <message>
        <source>the first element is not ink</source>
        <translation>第一个元素不是 ink</translation>
    </message>
    <message>
        <source>its groups are too deep</source>
        <translation>分组嵌套过深</translation>
    </message>
    <message>
        <source>a point has more than %1 values</source>
        <translation>一个点的数值多于 %1 个</translation>
    </message>
    <message>
        <source>the trace is not a list of points with %1 numbers each, or there are more than %2 points</source>
        <translation>轨迹不是由各含 %1 个数字的点组成的列表，或点数超过 %2</translation>
    </message>
    <message>
        <source>the trace has no X and Y</source>
        <translation>轨迹没有 X 和 Y</translation>
    </message>
    <message>
        <source>a point is farther than 1e7 units away</source>
        <translation>有一个点的距离超过 1e7 个单位</translation>
    </message>
    <message>
        <source>holds no notebook that can be read; save it with Rnote 0.5 or later</source>
        <translation>不含可读取的笔记；请用 Rnote 0.5 或更新版本保存</translation>
    </message>
    <message>
        <source>a point is not two numbers within ±1e7</source>
        <translation>有一个点不是两个在 ±1e7 之内的数字</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>数字多于 %1 个</translation>
    </message>
    <message>
        <source>is Universal Ink %1.%2; 3.0 and 3.1 can be read</source>
        <translation>是 Universal Ink %1.%2；可读取 3.0 和 3.1</translation>
    </message>
    <message>
        <source>is damaged: a part of it is not whole</source>
        <translation>已损坏：有一部分不完整</translation>
    </message>
    <message>
        <source>its part %1 is packed in a way that cannot be read</source>
        <translation>其中的 %1 部分采用了无法读取的压缩方式</translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>%n 种线型</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n 个形状</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>%n 段笔在纸面上方的移动</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>%n 个通道映射</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>%n 段录音</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>%n 张有格线或印刷内容的纸</numerusform>
        </translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone</source>
        <translation>Suffuse 的一个部分 %1 %2；请重新安装 Suffuse。它仅用于 PDF 文件</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>无法加载（%1）</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>属于另一个版本的 Suffuse</translation>
    </message>
    <message>
        <source>would have more than 2 GB</source>
        <translation>将超过 2 GB</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>此 PDF 文件中有 %n 幅画作，打开了第一幅。</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>PDF 文件</translation>
    </message>
    <message>
        <source>This is a PDF file, and %1.</source>
        <translation>这是 PDF 文件，而%1。</translation>
    </message>
    <message>
        <source>This PDF file is damaged: %1.</source>
        <translation>此 PDF 文件已损坏：%1。</translation>
    </message>
    <message>
        <source>This PDF file holds no painting. Suffuse opens those that it wrote; open a picture of its pages as a layer instead.</source>
        <translation>此 PDF 文件中没有画作。Suffuse 只能打开自己写出的 PDF；请改为将其页面的图像作为图层打开。</translation>
    </message>
    <message>
        <source>Another program changed this PDF file. What was opened is the painting as Suffuse exported it.</source>
        <translation>另一个程序更改了此 PDF 文件。打开的是 Suffuse 导出时的画作。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupCells</name>
    <message>
        <source>Clipped to what lies below it in its group</source>
        <translation>剪切到其组中下方的内容</translation>
    </message>
    <message>
        <source>A mask for the others in its group</source>
        <translation>其组中其他内容的蒙版</translation>
    </message>
    <message>
        <source>A wash: its strokes are one</source>
        <translation>淡彩：其笔画合为一笔</translation>
    </message>
    <message>
        <source>Shown alone</source>
        <translation>单独显示</translation>
    </message>
    <message>
        <source>A draft: left out of what is exported</source>
        <translation>草稿：不会被导出</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupHand</name>
    <message>
        <source>The group is locked: nothing changes.</source>
        <translation>组已锁定：没有变化。</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>更改组的不透明度</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>更改组的模式</translation>
    </message>
    <message>
        <source>Opacity of the group</source>
        <translation>组的不透明度</translation>
    </message>
</context>
<context>
    <name>suffuse::HintLabel</name>
    <message>
        <source>Hint</source>
        <translation>提示</translation>
    </message>
</context>
<context>
    <name>suffuse::HistoryPanel</name>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>Every change since the painting was opened. Click one to go back or forward to it.</source>
        <translation>打开画作以来的每次更改。点击某项即可回到或前进到该处。</translation>
    </message>
    <message>
        <source>This stroke</source>
        <translation>此笔画</translation>
    </message>
</context>
<context>
    <name>suffuse::Importing</name>
    <message>
        <source>Picture to Strokes</source>
        <translation>图片转为笔画</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>导入底图</translation>
    </message>
    <message>
        <source>Import Strokes</source>
        <translation>导入笔画</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was imported.</source>
        <translation>“%1”已损坏。其中完好的部分已导入。</translation>
    </message>
    <message>
        <source>Import picture as layer</source>
        <translation>将图片导入为图层</translation>
    </message>
    <message>
        <source>Add as &amp;Layer</source>
        <translation>添加为图层(&amp;L)</translation>
    </message>
    <message>
        <source>Use as &amp;Underlay</source>
        <translation>用作底图(&amp;U)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message>
        <source>Nothing is selected. Click a stroke to see and change its values.</source>
        <translation>未选择任何内容。点击一条笔画以查看和更改其数值。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke…</source>
        <translation>沿笔画变化…</translation>
    </message>
    <message>
        <source>Sets a value along the stroke: constant, as a ramp, or drawn as a curve.</source>
        <translation>设置沿笔画变化的值：恒定、渐变或手绘曲线。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段中的 %1 条</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>%Ln 个擦除线段</numerusform>
        </translation>
    </message>
    <message>
        <source>They make paint paler.</source>
        <translation>它们使颜料变淡。</translation>
    </message>
    <message>
        <source>They take paint away: the more density, the more.</source>
        <translation>它们擦去颜料：密度越大，擦去越多。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>其中 %Ln 个擦去颜料。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KeyboardFocus</name>
    <message>
        <source>The %1 dock has the keyboard; Esc gives it back to the canvas.</source>
        <translation>键盘焦点在“%1”面板中；按 Esc 可交还画布。</translation>
    </message>
    <message>
        <source>The canvas has the keyboard.</source>
        <translation>键盘焦点在画布中。</translation>
    </message>
    <message>
        <source>The tool bar “%1” has the keyboard; Esc gives it back to the canvas.</source>
        <translation>键盘焦点在“%1”工具栏中；按 Esc 可交还画布。</translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message>
        <source>Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.</source>
        <translation>拖出一条线，在其与笔画相交处插入节点。Shift：将笔画切开。Ctrl：以 15° 为步长。</translation>
    </message>
    <message>
        <source>Cut strokes</source>
        <translation>切割笔画</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>插入节点</translation>
    </message>
    <message>
        <source>%1 cut into %2</source>
        <extracomment>what the knife did; %1: &quot;2 strokes&quot;, %2: &quot;5 parts&quot;</extracomment>
        <translation>已将 %1切成 %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln 段</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inserted in %2</source>
        <extracomment>what the knife did; %1: &quot;3 nodes&quot;, %2: &quot;2 strokes&quot;</extracomment>
        <translation>已在 %2中插入 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>%Ln 个节点</numerusform>
        </translation>
    </message>
    <message>
        <source>There are nodes already where the line crosses strokes.</source>
        <translation>该线与笔画相交处已有节点。</translation>
    </message>
    <message>
        <source>The line crosses no stroke.</source>
        <translation>该线未与任何笔画相交。</translation>
    </message>
    <message>
        <source>The line crosses no selected stroke.</source>
        <translation>该线未与任何所选笔画相交。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>A fill is cut only where the line goes all the way through it.</source>
        <translation>只有当线完全穿过填充时，填充才会被切开。</translation>
    </message>
    <message>
        <source>Inserts nodes where a line crosses strokes; with Shift it cuts them apart there.</source>
        <translation>在直线与笔画相交处插入节点；按住 Shift 则在该处切断笔画。</translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message>
        <source>Tool Options</source>
        <translation>工具选项</translation>
    </message>
</context>
<context>
    <name>suffuse::MixingSection</name>
    <message>
        <source>Mixing</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>Paint colours over each other here. Shift+drag rubs, Ctrl+click picks.</source>
        <translation>在此叠涂颜色。Shift+拖动：涂抹；Ctrl+点击：取色。</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Paints with the current colour.</source>
        <translation>用当前颜色绘制。</translation>
    </message>
    <message>
        <source>Rub</source>
        <translation>涂抹</translation>
    </message>
    <message>
        <source>Carries the paint under the pointer along.</source>
        <translation>带动指针下的颜料。</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>取色</translation>
    </message>
    <message>
        <source>Makes the colour under the pointer the current one.</source>
        <translation>将指针下的颜色设为当前颜色。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>换一张空白纸。</translation>
    </message>
</context>
<context>
    <name>suffuse::MomentRow</name>
    <message>
        <source>Moment</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>All dried</source>
        <translation>全部干透</translation>
    </message>
    <message>
        <source>As it looks now</source>
        <translation>当前所见</translation>
    </message>
    <message>
        <source>At the time</source>
        <translation>指定时刻</translation>
    </message>
    <message>
        <source>The finished painting, the moment that the canvas shows, or any other.</source>
        <translation>完成的画作、画布显示的时刻，或任意其他时刻。</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Minutes and seconds, as the timeline shows them: 1:02.345</source>
        <translation>分和秒，与时间轴的写法相同：1:02.345</translation>
    </message>
</context>
<context>
    <name>suffuse::NewDialog</name>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>交换宽度和高度</translation>
    </message>
    <message>
        <source>C&amp;reate</source>
        <translation>创建(&amp;R)</translation>
    </message>
    <message>
        <source>New Painting</source>
        <translation>新建画作</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>画纸</translation>
    </message>
    <message>
        <source>Usual sizes, and sheets with a ground of their own</source>
        <translation>常用尺寸，以及自带底色的画纸</translation>
    </message>
    <message>
        <source>Sides in</source>
        <translation>边长单位</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>What width and height are given in. A pixel is a unit of the canvas.</source>
        <translation>宽度和高度所用的单位。一个像素就是画布的一个单位。</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels for each inch of paper. The sheet stays as large on paper.</source>
        <translation>每英寸纸张的像素数。纸上的大小不变。</translation>
    </message>
</context>
<context>
    <name>suffuse::NextNodeFields</name>
    <message>
        <source>X</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Where the next node is set, from the left. Return sets it, and so does a click</source>
        <translation>下一个节点的位置，从左边起。回车或点击放置节点</translation>
    </message>
    <message>
        <source>Y</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Where the next node is set, from the top. Return sets it, and so does a click</source>
        <translation>下一个节点的位置，从上边起。回车或点击放置节点</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>From the last node to the next one. Return sets it, and so does a click</source>
        <translation>从上一个节点到下一个节点。回车或点击放置节点</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a click</source>
        <translation>从上一个节点到下一个节点的方向，从右侧起顺时针。回车或点击放置节点</translation>
    </message>
    <message>
        <source>Close</source>
        <extracomment>closes an outline</extracomment>
        <translation>闭合</translation>
    </message>
    <message>
        <source>Closes the outline at its first node (Shift+Return)</source>
        <translation>在首节点处闭合轮廓（Shift+回车）</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeCommands</name>
    <message>
        <source>The joined stroke has the upper one&apos;s fill. Undo brings the other back.</source>
        <translation>连接后的笔画沿用上层笔画的填充。撤销可恢复另一个填充。</translation>
    </message>
    <message>
        <source>The joined stroke has no fill, as the upper one had none. Undo brings the lower one&apos;s back.</source>
        <translation>连接后的笔画没有填充，因为上层笔画没有填充。撤销可恢复下层笔画的填充。</translation>
    </message>
    <message>
        <source>Smooth nodes</source>
        <translation>平滑节点</translation>
    </message>
    <message>
        <source>Symmetric nodes</source>
        <translation>对称节点</translation>
    </message>
    <message>
        <source>Corner nodes</source>
        <translation>尖角节点</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>插入节点</translation>
    </message>
    <message>
        <source>Break stroke</source>
        <translation>断开笔画</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>连接节点</translation>
    </message>
    <message>
        <source>Reverse strokes</source>
        <translation>反转笔画方向</translation>
    </message>
    <message>
        <source>Delete nodes</source>
        <translation>删除节点</translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>删除线段</translation>
    </message>
    <message>
        <source>Bridge segments</source>
        <translation>桥接线段</translation>
    </message>
    <message>
        <source>A node alone has no paint: select the nodes at both ends of a segment, or take the whole stroke with the Select tool.</source>
        <translation>单独的节点没有颜料：请选择线段两端的节点，或用选择工具选取整条笔画。</translation>
    </message>
    <message>
        <source>The closed outline begins and ends at this node, so it has nothing more to break. Delete Segments (Ctrl+Del) opens it.</source>
        <translation>闭合轮廓在此节点开始并结束，此处已无可断开。“删除线段”（Ctrl+Del）可将其打开。</translation>
    </message>
    <message>
        <source>Join needs two ends of strokes: select one, and Shift+click the other or drag around both.</source>
        <translation>连接需要笔画的两个端点：先选择一个，再按住 Shift 点击另一个，或拖动框住两者。</translation>
    </message>
    <message>
        <source>These two ends cannot be joined.</source>
        <translation>这两个端点无法连接。</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeTool</name>
    <message>
        <source>Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.</source>
        <translation>拖动控制柄以弯曲曲线。Shift：使节点变为尖角。Ctrl：以 15° 为步长。</translation>
    </message>
    <message>
        <source>Insert node</source>
        <translation>插入节点</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>移动节点</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>移动节点</translation>
    </message>
    <message>
        <source>Click a segment to select it, Shift+click for a run or another stroke&apos;s, Ctrl+click to add or remove one. Drag around nodes.</source>
        <translation>点击选择线段，Shift+点击选择连续线段或其他笔画的线段，Ctrl+点击添加或移除一段。拖动框选节点。</translation>
    </message>
    <message>
        <source>Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. Shift+click for more.</source>
        <translation>拖动以移动节点，影响范围内柔和跟随（滚轮、Alt+拖动）。Ctrl：沿坐标轴，Ctrl+Alt：沿控制柄。Shift+点击选择更多。</translation>
    </message>
    <message>
        <source>Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to select the segment.</source>
        <translation>拖动以在影响范围内弯曲曲线（滚轮、Alt+拖动）。双击插入节点。点击选择线段。</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>移动擦除</translation>
    </message>
    <message>
        <source>Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.</source>
        <translation>移动擦除：它在所处的位置去除颜料。Ctrl：沿坐标轴移动。Esc：放弃。</translation>
    </message>
    <message>
        <source>Drag to move the erasure. Click to select it in all strokes, again for its part in this one, again for a segment. Delete removes it.</source>
        <translation>拖动可移动擦除。点击在所有笔画中选择它，再次点击选择它在此笔画中的部分，第三次选择其中一段。“删除”会移除它。</translation>
    </message>
    <message>
        <source>Move segments</source>
        <translation>移动线段</translation>
    </message>
    <message>
        <source>An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes the gradient away; Esc first, and Delete means the stroke.</source>
        <translation>渐变的一端不能单独删除。检查器中“渐变”旁的“移除”可去掉渐变；先按 Esc，“删除”便指笔画。</translation>
    </message>
    <message>
        <source>What was selected is deleted; its strokes are merely shown. Click what else is to go, or take whole strokes with the Select tool.</source>
        <translation>所选部分已删除，其笔画只是仍然显示。请点击还要删除的部分，或用选择工具选取整条笔画。</translation>
    </message>
</context>
<context>
    <name>suffuse::NumberField</name>
    <message>
        <source>“%1” is not a number. Sums such as 12*1.5 or +2 work too.</source>
        <translation>“%1”不是数字。也可以输入 12*1.5 或 +2 这样的算式。</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3 is possible.</source>
        <translation>%1 超出范围：允许 %2 到 %3。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: this number has no unit.</source>
        <translation>此处不能输入“%1”：这个数没有单位。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: the unit is %2.</source>
        <translation>此处不能输入“%1”：单位是 %2。</translation>
    </message>
    <message>
        <source> u</source>
        <translation> u</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in</source>
        <translation> in</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source> u²/s</source>
        <translation> u²/秒</translation>
    </message>
    <message>
        <source>%1 is out of range: more than 0 and up to %2 is possible.</source>
        <translation>%1 超出范围：允许大于 0 且不超过 %2。</translation>
    </message>
    <message>
        <source>%1 is the most that is possible.</source>
        <translation>最大为 %1。</translation>
    </message>
    <message>
        <source>%1 is the least that is possible.</source>
        <translation>最小为 %1。</translation>
    </message>
</context>
<context>
    <name>suffuse::PanTool</name>
    <message>
        <source>Drag to move the canvas. The wheel zooms; R and drag turns.</source>
        <translation>拖动以移动画布。滚轮缩放；按住 R 拖动可旋转。</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPad</name>
    <message>
        <source>Try your pen here.</source>
        <translation>在此试笔。</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPage</name>
    <message>
        <source>Pressure</source>
        <translation>压感</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>偏软</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>均衡</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>偏硬</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>How hard the pen must be pressed, for all brushes.</source>
        <translation>下笔所需的力度，适用于所有画笔。</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>换一张空白纸。</translation>
    </message>
    <message>
        <source>pressure of the pen →</source>
        <translation>笔的压力 →</translation>
    </message>
    <message>
        <source>↑ paints with</source>
        <translation>↑ 作画压感</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>压感曲线</translation>
    </message>
    <message>
        <source>Drag the points; click for another; drag one out to take it away.</source>
        <translation>拖动控制点；点击添加；拖出则移除。</translation>
    </message>
    <message>
        <source>Paint here with the brush in use; the dot on the curve is the pen&apos;s pressure.</source>
        <translation>用当前画笔在此作画；曲线上的圆点为笔的压力。</translation>
    </message>
    <message>
        <source>Only the pen and the mouse paint; fingers move the view</source>
        <translation>仅用笔和鼠标作画；手指移动视图</translation>
    </message>
    <message>
        <source>One finger moves the canvas, two zoom and turn it. Otherwise one finger paints.</source>
        <translation>单指移动画布，双指缩放和旋转。否则单指用于作画。</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>清空(&amp;L)</translation>
    </message>
</context>
<context>
    <name>suffuse::PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Format, depth, quality, resolution, size, area and moment under a name</source>
        <translation>以一个名称保存的格式、位深、质量、分辨率、尺寸、区域与时刻</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep what is set here as a preset</source>
        <translation>将此处的设置存为预设</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Forget the chosen preset</source>
        <translation>删除所选预设</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>There is a preset “%1”. Replace it?</source>
        <translation>已有预设“%1”。要替换吗？</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>保存预设</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>打印(&amp;P)</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Prints the canvas's colour; without it the paint lies on the paper as it is.</source>
        <translation>打印画布的颜色；不勾选时，颜料直接落在纸上。</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>打印到文件 (PDF)</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>打印机</translation>
    </message>
    <message>
        <source>Where the page comes out</source>
        <translation>页面从哪里输出</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. A file can be printed elsewhere.</source>
        <translation>这台电脑没有设置打印机。文件可以在别处打印。</translation>
    </message>
    <message>
        <source>The PDF file that is written: one page as large as the paper.</source>
        <translation>要写入的 PDF 文件：一页，与纸张一样大。</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>份数</translation>
    </message>
    <message>
        <source>How often the page is printed</source>
        <translation>页面打印几份</translation>
    </message>
    <message>
        <source>%1 – %2 × %3 mm</source>
        <translation>%1 – %2 × %3 毫米</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>与画面一样大</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>纵向</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>横向</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>How the paper lies</source>
        <translation>纸张的放置方向</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>纸张</translation>
    </message>
    <message>
        <source>The size of the paper</source>
        <translation>纸张的大小</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Left margin</source>
        <translation>左边距</translation>
    </message>
    <message>
        <source>Top margin</source>
        <translation>上边距</translation>
    </message>
    <message>
        <source>Right margin</source>
        <translation>右边距</translation>
    </message>
    <message>
        <source>Bottom margin</source>
        <translation>下边距</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> 毫米</translation>
    </message>
    <message>
        <source>What stays empty at this edge of the paper</source>
        <translation>纸张这一边留白的宽度</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Fit to the page</source>
        <translation>适合页面</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>实际尺寸</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Of the actual size</source>
        <translation>相对于实际尺寸</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>How large the picture lies on the paper</source>
        <translation>图片在纸上有多大</translation>
    </message>
    <message>
        <source>%1 dpi</source>
        <translation>%1 dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>How many dots an inch the picture is drawn with</source>
        <translation>每英寸用多少点绘制图片</translation>
    </message>
    <message>
        <source>Usual: %1 dpi</source>
        <translation>通常：%1 dpi</translation>
    </message>
    <message>
        <source>The printer's: %1 dpi</source>
        <translation>打印机的：%1 dpi</translation>
    </message>
    <message>
        <source>The margins leave no room on the paper.</source>
        <translation>边距在纸上没有留下空间。</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 mm on the paper.</source>
        <translation>图片在纸上为 %1 × %2 毫米。</translation>
    </message>
    <message>
        <source>What does not fit is cut off.</source>
        <translation>放不下的部分会被裁掉。</translation>
    </message>
    <message>
        <source>PDF files</source>
        <translation>PDF 文件</translation>
    </message>
    <message>
        <source>“%1” is not there any more. Choose another printer.</source>
        <translation>“%1”已不存在。请选择其他打印机。</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintJob</name>
    <message>
        <source>The page does not fit into memory.</source>
        <translation>内存放不下这一页。</translation>
    </message>
    <message>
        <source>There is no room for the page on the disk: %1</source>
        <translation>磁盘上没有存放此页的空间：%1</translation>
    </message>
    <message>
        <source>The printer does not take the page. See whether it is there, or print to a file.</source>
        <translation>打印机没有接受此页。请检查打印机是否可用，或打印到文件。</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintRows</name>
    <message>
        <source>Print size</source>
        <translation>打印尺寸</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>纸上宽度</translation>
    </message>
    <message>
        <source>Width on paper; the height and the pixels follow.</source>
        <translation>纸上宽度；高度与像素随之改变。</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>纸上高度</translation>
    </message>
    <message>
        <source>Height on paper; the width and the pixels follow.</source>
        <translation>纸上高度；宽度与像素随之改变。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>in</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>毫米或英寸</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels an inch. PNG, TIFF, JPEG and EXR files say it.</source>
        <translation>每英寸像素数。PNG、TIFF、JPEG 与 EXR 文件会注明。</translation>
    </message>
</context>
<context>
    <name>suffuse::ProbePanel</name>
    <message>
        <source>Rest the pointer on the painting: what it is made of there is listed here, and stays when you come here to click it.</source>
        <translation>将指针停在画作上：此处会列出该点的构成，指针移到此处点击时列表保持不变。</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>密度 φ</translation>
    </message>
    <message>
        <source>Of strokes: share of the colour. Of segments: share of the stroke&apos;s density.</source>
        <translation>笔画：在颜色中的占比。线段：在笔画密度中的占比。</translation>
    </message>
    <message>
        <source>Strokes under the pointer</source>
        <translation>指针下的笔画</translation>
    </message>
    <message>
        <source>Density over the age</source>
        <translation>密度随时间的变化</translation>
    </message>
    <message>
        <source>The density of the chosen stroke at this place from when it was painted until it is dry. Dashed: the density from which it is seen.</source>
        <translation>选定笔画在此处的密度，从落笔到干透。虚线：开始可见的密度。</translation>
    </message>
    <message>
        <source>%1, %2 · paper η %3</source>
        <translation>%1, %2 · 纸张 η %3</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>线段 %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>The topmost stroke comes first, with its share of the colour.</source>
        <translation>最上方的笔画排在最前，并附其颜色占比。</translation>
    </message>
</context>
<context>
    <name>suffuse::PushTool</name>
    <message>
        <source>Drag to push strokes along. [ and ] change the size.</source>
        <translation>拖动以推移笔画。[ 和 ] 改变大小。</translation>
    </message>
    <message>
        <source>Drag to push the selected strokes along. [ and ] change the size.</source>
        <translation>拖动以推移所选笔画。[ 和 ] 改变大小。</translation>
    </message>
    <message>
        <source>Drag to turn strokes into the direction of the drag.</source>
        <translation>拖动使笔画转向拖动方向。</translation>
    </message>
    <message>
        <source>Drag to turn the selected strokes into the direction of the drag.</source>
        <translation>拖动使所选笔画转向拖动方向。</translation>
    </message>
    <message>
        <source>Hold to pull strokes together. Shift: apart.</source>
        <translation>按住使笔画收拢。Shift：散开。</translation>
    </message>
    <message>
        <source>Hold to pull the selected strokes together. Shift: apart.</source>
        <translation>按住使所选笔画收拢。Shift：散开。</translation>
    </message>
    <message>
        <source>Drag to roughen strokes.</source>
        <translation>拖动使笔画粗糙。</translation>
    </message>
    <message>
        <source>Drag to roughen the selected strokes.</source>
        <translation>拖动使所选笔画粗糙。</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>推移</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>梳理</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>收拢</translation>
    </message>
    <message>
        <source>Roughen</source>
        <translation>粗糙化</translation>
    </message>
    <message>
        <source>What the circle does to strokes</source>
        <translation>圆圈对笔画的作用</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>How much of it one touch does; a pen&apos;s pressure takes from it</source>
        <translation>每次触碰的作用量；笔的压力会减弱它</translation>
    </message>
    <message>
        <source>Push strokes</source>
        <translation>推移笔画</translation>
    </message>
    <message>
        <source>Comb strokes</source>
        <translation>梳理笔画</translation>
    </message>
    <message>
        <source>Pinch strokes</source>
        <translation>收拢笔画</translation>
    </message>
    <message>
        <source>Roughen strokes</source>
        <translation>粗糙化笔画</translation>
    </message>
    <message>
        <source>Letters are left alone while nothing is selected. Select the text to change its letters.</source>
        <translation>未选择任何内容时，文字中的字形保持不变。要改变它们，请先选择该文字。</translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message>
        <source>Recolour Artwork</source>
        <translation>重新着色图稿</translation>
    </message>
    <message>
        <source>Colours of what is selected</source>
        <translation>所选内容的颜色</translation>
    </message>
    <message>
        <source>Colours of the painting</source>
        <translation>画中的颜色</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>The colours with the most paint come first. Choose one, or several, and give it another colour: it changes everywhere.</source>
        <translation>用量最多的颜色排在最前。选择一种或多种并换成另一种颜色：所有位置都会更改。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>用量</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>线段</translation>
    </message>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>%n 种看起来相近的颜色</numerusform>
        </translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>十六进制</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB 颜色：#rrggbb、#rgb 或 CSS 写法，如 rgb(255, 0, 128)、hsl(20, 50%, 40%)、teal</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>色板</translation>
    </message>
    <message>
        <source>The swatches of the painting. Click: the chosen colour becomes this one.</source>
        <translation>画的色板。点击：所选颜色变为此色。</translation>
    </message>
    <message>
        <source>Keep differences</source>
        <translation>保持差异</translation>
    </message>
    <message>
        <source>Colours that are one line in the list change together and stay different. Else they become the same.</source>
        <translation>列表中同一行的颜色一起变化并保持不同；否则变得相同。</translation>
    </message>
    <message>
        <source>Reset the Colour</source>
        <translation>重置颜色</translation>
    </message>
    <message>
        <source>Gives the chosen colours back what they were</source>
        <translation>将所选颜色恢复原样</translation>
    </message>
    <message>
        <source>All colours</source>
        <translation>所有颜色</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Turns all hues around the colour wheel</source>
        <translation>在色轮上旋转所有色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>饱和度</translation>
    </message>
    <message>
        <source>100 %: as it is; 0 %: grey; more: more colourful</source>
        <translation>100 %：保持不变；0 %：灰色；更大：更鲜艳</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>Above 0 % nearer to white, below nearer to black</source>
        <translation>大于 0 % 趋向白色，小于 0 % 趋向黑色</translation>
    </message>
    <message>
        <source>Map to the nearest swatches</source>
        <translation>映射到最接近的色板</translation>
    </message>
    <message>
        <source>Each colour becomes the swatch of the painting that looks nearest</source>
        <translation>每种颜色变为画中看起来最接近的色板</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>“%1”不是颜色。请写成 #rrggbb，例如 #2f6690。</translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message>
        <source>Recover Paintings</source>
        <translation>恢复画作</translation>
    </message>
    <message>
        <source>Suffuse ended before these paintings were saved. They open as they were at the last stroke; files on the disk are left as they are.</source>
        <translation>Suffuse 在保存这些画作之前结束了。它们将以最后一笔时的样子打开；磁盘上的文件保持原样。</translation>
    </message>
    <message>
        <source>Paintings that can be recovered</source>
        <translation>可以恢复的画作</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>画作</translation>
    </message>
    <message>
        <source>Last Change</source>
        <translation>最后更改</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>以后再说(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>丢弃(&amp;D)…</translation>
    </message>
    <message>
        <source>Opens the selected paintings, without a file of their own</source>
        <translation>打开所选画作，不带各自的文件</translation>
    </message>
    <message>
        <source>Asks again when Suffuse starts the next time</source>
        <translation>下次启动 Suffuse 时再询问</translation>
    </message>
    <message>
        <source>Removes the selected paintings for good</source>
        <translation>永久移除所选画作</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>Discard “%1”?</source>
        <translation>丢弃“%1”？</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>丢弃 %n 幅画作？</numerusform>
        </translation>
    </message>
    <message>
        <source>What was painted since the last save is then lost for good.</source>
        <translation>上次保存以来绘制的内容将永久丢失。</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>丢弃(&amp;D)</translation>
    </message>
</context>
<context>
    <name>suffuse::RedrawTool</name>
    <message>
        <source>Draw from a stroke and back to it: the part between follows the line.</source>
        <translation>从笔画画出再画回：中间的部分跟随线条。</translation>
    </message>
    <message>
        <source>Draw from a selected stroke and back to it: the part between follows.</source>
        <translation>从所选笔画画出再画回：中间的部分随之改变。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>Of the brush in hand</source>
        <translation>当前画笔的</translation>
    </message>
    <message>
        <source>What the new part is painted with, and when</source>
        <translation>新的部分用什么、在何时绘制</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>重绘</translation>
    </message>
    <message>
        <source>The line begins and ends at no stroke that can be changed.</source>
        <translation>线条的起点和终点都不在可更改的笔画上。</translation>
    </message>
    <message>
        <source>The line begins and ends at no selected stroke that can be changed.</source>
        <translation>线条的起点和终点都不在可更改的所选笔画上。</translation>
    </message>
</context>
<context>
    <name>suffuse::ReshapeDialog</name>
    <message>
        <source>Reshape</source>
        <translation>整形</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>简化</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>拉直</translation>
    </message>
    <message>
        <source>Grow or shrink</source>
        <translation>加宽或缩窄</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>How far curves may move</source>
        <translation>曲线可移动的距离</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>How far spreads, densities, colours and times may differ that become one</source>
        <translation>合并时扩散、密度、颜色和时间允许的差异</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Wiggles of this length and shorter ones go</source>
        <translation>此长度及更短的抖动会消失</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>程度</translation>
    </message>
    <message>
        <source>0 %: as it is; 100 %: a straight line</source>
        <translation>0 %：不变；100 %：直线</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Of the paint; below 100 % it shrinks</source>
        <translation>颜料的宽度；低于 100 % 则缩窄</translation>
    </message>
    <message>
        <source>To the right of the stroke&apos;s direction; below 0 to the left</source>
        <translation>向笔画方向的右侧；负值向左</translation>
    </message>
    <message>
        <source>%1 → %2 segments</source>
        <extracomment>%1, %2: numbers of segments before and after</extracomment>
        <translation>%1 → %2 条线段</translation>
    </message>
    <message>
        <source>%1, picture differs by %2</source>
        <extracomment>%1: &quot;12 → 3 segments&quot;; %2: &quot;0.4 %&quot;, the mean difference of the pictures</extracomment>
        <translation>%1，画面相差 %2</translation>
    </message>
</context>
<context>
    <name>suffuse::RewetRows</name>
    <message>
        <source>Wetted again</source>
        <translation>再次润湿</translation>
    </message>
    <message>
        <source>… and more</source>
        <translation>…以及更多</translation>
    </message>
    <message>
        <source>at %1 for %2 s</source>
        <translation>于 %1，持续 %2 秒</translation>
    </message>
    <message>
        <source>at %1 for %2 s, some segments</source>
        <translation>于 %1，持续 %2 秒，部分线段</translation>
    </message>
    <message>
        <source>The selected paint is not wetted then</source>
        <translation>所选颜料届时不再润湿</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>移除再次润湿</translation>
    </message>
</context>
<context>
    <name>suffuse::ScreenColourRows</name>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>饱和度</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>Hue on the circle of the screen&apos;s colours: 0° red, 120° green, 240° blue</source>
        <translation>屏幕色环上的色相：0° 红，120° 绿，240° 蓝</translation>
    </message>
    <message>
        <source>0 %: grey; 100 %: as colourful as a screen can be</source>
        <translation>0 %：灰色；100 %：屏幕所能显示的最鲜艳</translation>
    </message>
    <message>
        <source>0 %: black; 100 %: as bright as the colour can be</source>
        <translation>0 %：黑色；100 %：该颜色所能达到的最亮</translation>
    </message>
    <message>
        <source>Red light of the screen, 0 to 255</source>
        <translation>屏幕的红光，0 到 255</translation>
    </message>
    <message>
        <source>Green light of the screen, 0 to 255</source>
        <translation>屏幕的绿光，0 到 255</translation>
    </message>
    <message>
        <source>Blue light of the screen, 0 to 255</source>
        <translation>屏幕的蓝光，0 到 255</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>suffuse::SegmentSection</name>
    <message>
        <source>Diffusion D</source>
        <translation>扩散系数 D</translation>
    </message>
    <message>
        <source>How fast the paint spreads: the spread grows with the root of D times time.</source>
        <translation>颜料扩散的快慢：扩散距离随 D 与时间乘积的平方根增长。</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>密度 φ</translation>
    </message>
    <message>
        <source>How much paint the segment gives off along its length.</source>
        <translation>线段沿其长度释放的颜料量。</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>干燥时间</translation>
    </message>
    <message>
        <source>t_max: how long the paint spreads after it was laid down.</source>
        <translation>t_max：颜料落下后扩散多久。</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>Change diffusion</source>
        <translation>更改扩散系数</translation>
    </message>
    <message>
        <source>Change density</source>
        <translation>更改密度</translation>
    </message>
    <message>
        <source>Change granulation</source>
        <translation>更改颗粒</translation>
    </message>
    <message>
        <source>Change drying time</source>
        <translation>更改干燥时间</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>所选内容的颜色</translation>
    </message>
    <message>
        <source>Colour of the selection. Click: paint with it.</source>
        <translation>所选内容的颜色。点击以此颜色作画。</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>更改不透明度</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>更改颜色</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>各向异性</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Direction of the anisotropy, clockwise from the horizontal.</source>
        <translation>各向异性的方向，从水平方向起顺时针计算。</translation>
    </message>
    <message>
        <source>Change anisotropy</source>
        <translation>更改各向异性</translation>
    </message>
    <message>
        <source>Change angle</source>
        <translation>更改角度</translation>
    </message>
    <message>
        <source>How many times D along the angle is D across it; 1 spreads evenly.</source>
        <translation>沿该角度的 D 是垂直方向 D 的多少倍；1 表示均匀扩散。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How much the paint covers at full density</source>
        <translation>密度饱和时颜料的覆盖程度</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Share of red pigment</source>
        <translation>红色颜料的比例</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Share of yellow pigment</source>
        <translation>黄色颜料的比例</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Share of blue pigment</source>
        <translation>蓝色颜料的比例</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于全部所选内容：某个值会超出范围。</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>诞生时间</translation>
    </message>
    <message>
        <source>When the stroke, or what is selected of it, begins. All of that moves in time as one.</source>
        <translation>笔画或其选中部分何时开始；这些内容会作为整体在时间上移动。</translation>
    </message>
    <message>
        <source>Change birth</source>
        <translation>更改诞生时间</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Granulation</source>
        <translation>颗粒</translation>
    </message>
    <message>
        <source>How much of the paper&apos;s grain shows: 0 % is smooth, 100 % shows all of it. Files and scripts hold ω, which is 1 where this is 0 %.</source>
        <translation>显现多少纸张颗粒：0 % 为光滑，100 % 完全显现。文件和脚本中存的是 ω，此处为 0 % 时 ω 为 1。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Width of a dry line at full pressure, in units; sets the diffusion.</source>
        <translation>全压力下干燥线条的宽度，以单位计；由此设定扩散。</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>Density in the middle of the stroke at full pressure.</source>
        <translation>全压感时笔画中央的密度。</translation>
    </message>
    <message>
        <source>String</source>
        <translation>绳长</translation>
    </message>
    <message>
        <source>Its length on the screen</source>
        <translation>绳子在屏幕上的长度</translation>
    </message>
    <message>
        <source>Pigment β</source>
        <translation>颜料 β</translation>
    </message>
    <message>
        <source>Share of the colour below that stays: 0 % covers, 100 % adds.</source>
        <translation>下层颜色保留的比例：0 % 覆盖，100 % 叠加。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>How deep the grain goes.</source>
        <translation>颗粒的深浅。</translation>
    </message>
    <message>
        <source>How far the stroke lags behind</source>
        <translation>笔画滞后的程度</translation>
    </message>
    <message>
        <source>Parameter of the style</source>
        <translation>样式的参数</translation>
    </message>
    <message>
        <source>Threshold ξ1</source>
        <translation>阈值 ξ1</translation>
    </message>
    <message>
        <source>Softness ξ2</source>
        <translation>柔和度 ξ2</translation>
    </message>
    <message>
        <source>Full at ξ1</source>
        <translation>饱和点 ξ1</translation>
    </message>
    <message>
        <source>Steepness ξ2</source>
        <translation>陡度 ξ2</translation>
    </message>
    <message>
        <source>Edge ξ1</source>
        <translation>边缘 ξ1</translation>
    </message>
    <message>
        <source>Lightening ξ2</source>
        <translation>提亮 ξ2</translation>
    </message>
    <message>
        <source>Strength ξ3</source>
        <translation>强度 ξ3</translation>
    </message>
    <message>
        <source>Density at which the stroke covers by half.</source>
        <translation>笔画覆盖一半时的密度。</translation>
    </message>
    <message>
        <source>How gently the edge fades.</source>
        <translation>边缘过渡的柔和程度。</translation>
    </message>
    <message>
        <source>Density from which the stroke covers fully.</source>
        <translation>笔画完全覆盖所需的密度。</translation>
    </message>
    <message>
        <source>How steeply coverage grows with density.</source>
        <translation>覆盖率随密度增长的陡度。</translation>
    </message>
    <message>
        <source>Density at which the dark rim stands.</source>
        <translation>深色边缘所在的密度。</translation>
    </message>
    <message>
        <source>How much the inside is lighter than the rim; at most 1.26·ξ1.</source>
        <translation>内部比边缘浅多少；最大为 1.26·ξ1。</translation>
    </message>
    <message>
        <source>Coverage far inside the stroke.</source>
        <translation>笔画内部深处的覆盖率。</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Feathering</source>
        <translation>羽化</translation>
    </message>
    <message>
        <source>Dark edges</source>
        <translation>深色边缘</translation>
    </message>
    <message>
        <source>Covering (alpha)</source>
        <translation>覆盖（alpha）</translation>
    </message>
    <message>
        <source>Pigment (β)</source>
        <translation>颜料（β）</translation>
    </message>
    <message>
        <source>Erasure</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>加权</translation>
    </message>
    <message>
        <source>Pulled string</source>
        <translation>拉绳</translation>
    </message>
</context>
<context>
    <name>suffuse::SelectTool</name>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.</source>
        <translation>指针下的笔画 %1 / %2（从最上层数起）。再次 Alt+点击：下一条。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1：%3 中的第 %2 条</translation>
    </message>
    <message>
        <source>%1: moved by %2, %3</source>
        <translation>%1：已移动 %2, %3</translation>
    </message>
</context>
<context>
    <name>suffuse::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>System</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Colours of the windows</source>
        <translation>窗口的颜色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>光栅</translation>
    </message>
    <message>
        <source>All cores</source>
        <translation>所有核心</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>渲染器</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>压感笔</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the last one, “~2” the one before. File ▸ Restore Backup brings one back.</source>
        <translation>保存画作时保留多少个早先版本：旁边的“name.suffuse~”是上一个，“~2”是再前一个。可用 文件 ▸ 恢复备份 取回。</translation>
    </message>
    <message>
        <source>Language of the program</source>
        <translation>程序的语言</translation>
    </message>
    <message>
        <source>How the picture comes to the screen</source>
        <translation>画面显示到屏幕上的方式</translation>
    </message>
    <message>
        <source>What computes the picture</source>
        <translation>由什么计算画面</translation>
    </message>
    <message>
        <source>Processor threads for drawing</source>
        <translation>绘制所用的处理器线程数</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>动态效果</translation>
    </message>
    <message>
        <source>Whether docks glide to their places and carets blink</source>
        <translation>停靠面板是否滑动到位，光标是否闪烁</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>减少</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>完整</translation>
    </message>
</context>
<context>
    <name>suffuse::SheetView</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
</context>
<context>
    <name>suffuse::ShortcutsDialog</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>搜索快捷键</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut holds this text.</source>
        <translation>仅显示名称或快捷键包含此文本的命令。</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Choose a command, then press its new shortcut below.</source>
        <translation>选择命令，然后在下方按下新的快捷键。</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>按下按键</translation>
    </message>
    <message>
        <source>No shortcut for this command</source>
        <translation>此命令不使用快捷键</translation>
    </message>
    <message>
        <source>This command&apos;s own shortcut</source>
        <translation>此命令的默认快捷键</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” and “%3”. Give one of them another shortcut.</source>
        <translation>%1 同时属于“%2”和“%3”。请为其中之一设置其他快捷键。</translation>
    </message>
    <message>
        <source>Takes the shortcut away from the other command</source>
        <translation>从另一个命令取走该快捷键</translation>
    </message>
    <message>
        <source>Fixed: no command can have these keys.</source>
        <translation>固定：任何命令都不能使用这些键。</translation>
    </message>
    <message>
        <source>%1 is fixed: “%2”. Give “%3” another shortcut.</source>
        <translation>%1 是固定的：“%2”。请为“%3”另选快捷键。</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>接管(&amp;T)</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>生效位置</translation>
    </message>
    <message>
        <source>Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there.</source>
        <translation>快捷键生效的位置。在面板中不按 Ctrl 或 Alt 键入的内容留在该面板。</translation>
    </message>
</context>
<context>
    <name>suffuse::SizedTool</name>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Diameter of the circle ([ and ] change it)</source>
        <translation>圆圈的直径（[ 和 ] 可更改）</translation>
    </message>
</context>
<context>
    <name>suffuse::SliderField</name>
    <message>
        <source>Double-click: back to the default.</source>
        <translation>双击：恢复默认值。</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1，滑块</translation>
    </message>
    <message>
        <source>The values differ. The slider multiplies each of them; with Ctrl it makes them one.</source>
        <translation>各值不同。滑块将每个值相乘；按住 Ctrl 则统一为一个值。</translation>
    </message>
    <message>
        <source>The values differ. The slider adds to each of them; with Ctrl it makes them one.</source>
        <translation>各值不同。滑块对每个值进行增减；按住 Ctrl 则统一为一个值。</translation>
    </message>
    <message>
        <source>The values differ. A number makes them one; *1.2 or +2 changes each of them.</source>
        <translation>各值不同。输入数字则统一为一个值；*1.2 或 +2 会更改每个值。</translation>
    </message>
</context>
<context>
    <name>suffuse::SoftReach</name>
    <message>
        <source>Reach</source>
        <translation>影响范围</translation>
    </message>
    <message>
        <source>How far along the stroke a dragged node or curve takes along what lies near; 0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)</source>
        <translation>拖动节点或曲线时沿笔画带动邻近部分的距离；0：不带动（拖动时用滚轮或 [ 和 ]，或按住 Alt 拖动可更改）</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Let the reach follow the view: soft where nodes would crowd, else the node alone</source>
        <translation>让影响范围随视图而定：节点密集处柔和带动，否则只移动该节点</translation>
    </message>
    <message>
        <source>Let the reach follow the view</source>
        <translation>让影响范围随视图而定</translation>
    </message>
</context>
<context>
    <name>suffuse::StatusLine</name>
    <message>
        <source>Position of the pointer, in what the rulers count</source>
        <translation>指针位置，单位与标尺相同</translation>
    </message>
    <message>
        <source>Zoom, and the angle by which the canvas is turned</source>
        <translation>缩放比例与画布旋转角度</translation>
    </message>
    <message>
        <source>What renders the picture</source>
        <translation>渲染图片的后端</translation>
    </message>
    <message>
        <source>Time that the last frame took</source>
        <translation>上一帧所用时间</translation>
    </message>
    <message>
        <source>You paint in the past: what came later covers it.</source>
        <extracomment>instead of what the brush does, while the timeline shows a moment of the past</extracomment>
        <translation>您正在过去的时刻作画：之后的内容会将其覆盖。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>a position: x, y</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>%1 ms, coarse</source>
        <translation>%1 毫秒，粗略</translation>
    </message>
    <message>
        <source>Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and lifts it; + and - change its pressure; Esc puts it away.</source>
        <translation>方向键移动画笔，按住 Shift 移动较远，按住 Alt 微移；空格键落笔和抬笔；+ 和 - 改变压力；Esc 收起画笔。</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeHistoryList</name>
    <message>
        <source>History of the selected stroke</source>
        <translation>所选笔画的历史记录</translation>
    </message>
    <message>
        <source>What was done to the selected stroke. Click a state to put this stroke back to it; everything else stays as it is.</source>
        <translation>对所选笔画所做的操作。点击某个状态可使此笔画恢复到该状态；其他内容保持不变。</translation>
    </message>
    <message>
        <source>As it was at first</source>
        <translation>最初状态</translation>
    </message>
    <message>
        <source>Put stroke back</source>
        <translation>恢复笔画</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeSection</name>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the selected strokes, as the list of strokes shows it.</source>
        <translation>所选笔画在笔画列表中显示的名称。</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>重命名笔画</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>颜料与下层的混合方式：覆盖，或颜料叠加。</translation>
    </message>
    <message>
        <source>Change pigment mixing</source>
        <translation>更改颜料混合</translation>
    </message>
    <message>
        <source>Change mixing</source>
        <translation>更改混合</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于全部所选内容：某个值会超出范围。</translation>
    </message>
    <message>
        <source>The mixing of the wash is seen in place of this one.</source>
        <translation>看到的是淡彩组的混合，而不是这里的混合。</translation>
    </message>
</context>
<context>
    <name>suffuse::WashRows</name>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>How the density of all strokes of the wash becomes coverage.</source>
        <translation>淡彩组所有笔画的密度如何变为覆盖。</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>How the wash mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>淡彩组如何与其下方混合：覆盖，或颜料相加。</translation>
    </message>
    <message>
        <source>Change wash</source>
        <translation>更改淡彩组</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>不能用于全部所选内容：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>Visible. Click: hide.</source>
        <translation>可见。点击隐藏。</translation>
    </message>
    <message>
        <source>Hidden. Click: show.</source>
        <translation>已隐藏。点击显示。</translation>
    </message>
    <message>
        <source>Locked. Click: unlock.</source>
        <translation>已锁定。点击解锁。</translation>
    </message>
    <message>
        <source>Not locked. Click: lock.</source>
        <translation>未锁定。点击锁定。</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>组 %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>重命名组</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>重命名笔画</translation>
    </message>
    <message>
        <source>Hide group</source>
        <translation>隐藏组</translation>
    </message>
    <message>
        <source>Show group</source>
        <translation>显示组</translation>
    </message>
    <message>
        <source>Unlock group</source>
        <translation>解锁组</translation>
    </message>
    <message>
        <source>Lock group</source>
        <translation>锁定组</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>隐藏笔画</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>显示笔画</translation>
    </message>
    <message>
        <source>Unlock stroke</source>
        <translation>解锁笔画</translation>
    </message>
    <message>
        <source>Lock stroke</source>
        <translation>锁定笔画</translation>
    </message>
    <message>
        <source>Reorder strokes</source>
        <translation>调整笔画顺序</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>线段 %1</translation>
    </message>
    <message>
        <source>All in it is hidden. Click: show it.</source>
        <translation>其中全部已隐藏。点击显示。</translation>
    </message>
    <message>
        <source>Some of it is hidden. Click: hide the group.</source>
        <translation>其中部分已隐藏。点击隐藏整组。</translation>
    </message>
    <message>
        <source>All in it is locked. Click: unlock it.</source>
        <translation>其中全部已锁定。点击解锁。</translation>
    </message>
    <message>
        <source>Some of it is locked. Click: lock the group.</source>
        <translation>其中部分已锁定。点击锁定整组。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>%Ln 段</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>%Ln 处擦除</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between &quot;3 pieces&quot; and &quot;12 erasures&quot;</extracomment>
        <translation>，</translation>
    </message>
    <message>
        <source>mixes by itself</source>
        <translation>自行混合</translation>
    </message>
    <message>
        <source>%1, painted on</source>
        <translation>%1，正在其上绘画</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesPanel</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search strokes</source>
        <translation>搜索笔画</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>The topmost stroke comes first. Drag to reorder, double-click to rename; a right click offers more.</source>
        <translation>最上层的笔画排在最前。拖动以调整顺序，双击以重命名；右键点击有更多命令。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>Mo&amp;ve Up</source>
        <translation>上移(&amp;V)</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>下移(&amp;W)</translation>
    </message>
    <message>
        <source>Select rows to move them.</source>
        <translation>请先选择要移动的行。</translation>
    </message>
    <message>
        <source>Nothing changes: this is on top already.</source>
        <translation>没有变化：已在最上方。</translation>
    </message>
    <message>
        <source>Nothing changes: this is at the bottom already.</source>
        <translation>没有变化：已在最下方。</translation>
    </message>
    <message>
        <source>Nothing changes: locked strokes stay in place.</source>
        <translation>没有变化：锁定的笔画保持原位。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Select &amp;Same</source>
        <translation>选择相同项(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>样式(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>画笔(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>显示(&amp;O)</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>解锁(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>锁定(&amp;L)</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>隐藏笔画</translation>
    </message>
    <message>
        <source>Show strokes</source>
        <translation>显示笔画</translation>
    </message>
    <message>
        <source>Unlock strokes</source>
        <translation>解锁笔画</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>锁定笔画</translation>
    </message>
    <message>
        <source>Shows only strokes and groups whose name holds this text. Return selects them.</source>
        <translation>只显示名称包含此文字的笔画和组。按回车键选中它们。</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>No stroke is called “%1”.</source>
        <translation>没有名为“%1”的笔画。</translation>
    </message>
    <message>
        <source>While the list is searched, rows are not dragged: between those that show there may be others. Clear the search first.</source>
        <translation>搜索列表时不能拖动行：显示的行之间可能还有其他行。请先清除搜索。</translation>
    </message>
    <message>
        <source>Mi&amp;x by Itself</source>
        <translation>自行混合(&amp;X)</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>组自行混合</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>组与下方混合</translation>
    </message>
    <message>
        <source>New layer: %1</source>
        <translation>新图层：%1</translation>
    </message>
    <message>
        <source>Painting on: %1</source>
        <translation>绘画于：%1</translation>
    </message>
    <message>
        <source>The layer comes into the list with the first stroke that is painted.</source>
        <translation>画下第一笔时，图层才会出现在列表中。</translation>
    </message>
    <message>
        <source>What is painted goes into this group. A click beside all rows: on top of all again.</source>
        <translation>所画内容进入此群组。在行外点击：重新画在所有内容之上。</translation>
    </message>
    <message>
        <source>Painting on top of all</source>
        <translation>在最上方绘画</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>模式(&amp;M)</translation>
    </message>
    <message>
        <source>O&amp;pacity…</source>
        <translation>不透明度(&amp;P)…</translation>
    </message>
    <message>
        <source>New clipped layer: %1</source>
        <translation>新剪贴图层：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::StyleSection</name>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>归属</translation>
    </message>
    <message>
        <source>Whether the segments follow their stroke&apos;s style or have their own.</source>
        <translation>线段沿用所属笔画的样式，还是使用自己的样式。</translation>
    </message>
    <message>
        <source>The stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>These segments</source>
        <translation>这些线段</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>密度如何转化为覆盖率。</translation>
    </message>
    <message>
        <source>Change style</source>
        <translation>更改样式</translation>
    </message>
    <message>
        <source>Give segments their own style</source>
        <translation>赋予线段独立样式</translation>
    </message>
    <message>
        <source>Follow the stroke&apos;s style</source>
        <translation>沿用笔画样式</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>无法应用于全部所选内容：%1</translation>
    </message>
    <message>
        <source>The style of the wash is seen in place of this one.</source>
        <translation>看到的是淡彩组的样式，而不是这里的样式。</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchGrid</name>
    <message>
        <source>Add swatch</source>
        <translation>添加色板</translation>
    </message>
    <message>
        <source>Move swatch</source>
        <translation>移动色板</translation>
    </message>
    <message>
        <source>Rename swatch</source>
        <translation>重命名色板</translation>
    </message>
    <message>
        <source>Remove swatch</source>
        <translation>移除色板</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Link swatch</source>
        <translation>链接色板</translation>
    </message>
    <message>
        <source>Unlink swatch</source>
        <translation>取消色板链接</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>已链接</translation>
    </message>
    <message>
        <source>Change the Colour</source>
        <translation>更改颜色</translation>
    </message>
    <message>
        <source>Linked to What Is Painted with It</source>
        <translation>与用它绘制的内容链接</translation>
    </message>
    <message>
        <source>Select What Has This Colour</source>
        <translation>选择使用此颜色的内容</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchesSection</name>
    <message>
        <source>Swatches</source>
        <translation>色板</translation>
    </message>
    <message>
        <source>Add swatch</source>
        <translation>添加色板</translation>
    </message>
    <message>
        <source>Keeps the current colour with the painting.</source>
        <translation>将当前颜色随画作保存。</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>调色板</translation>
    </message>
    <message>
        <source>GIMP palettes in and out</source>
        <translation>导入和导出 GIMP 调色板</translation>
    </message>
    <message>
        <source>Colours kept with the painting. Click: take it. Drag to move; Delete removes.</source>
        <translation>随画作保存的颜色。点击选用。拖动以移动；Delete 键移除。</translation>
    </message>
    <message>
        <source>None yet: + keeps the current colour.</source>
        <translation>尚无色板：+ 保存当前颜色。</translation>
    </message>
    <message>
        <source>GIMP palettes</source>
        <translation>GIMP 调色板</translation>
    </message>
    <message>
        <source>Import palette</source>
        <translation>导入调色板</translation>
    </message>
    <message>
        <source>Export palette</source>
        <translation>导出调色板</translation>
    </message>
    <message>
        <source>Remove all swatches</source>
        <translation>移除所有色板</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>Map Colours to Swatches</source>
        <translation>将颜色映射到色板</translation>
    </message>
    <message>
        <source>Gives what is selected, or else all of the painting, the swatch that looks nearest</source>
        <translation>为所选内容（若无则为整幅画）换上看起来最接近的色板</translation>
    </message>
    <message>
        <source>Import Palette…</source>
        <translation>导入调色板…</translation>
    </message>
    <message>
        <source>Export Palette…</source>
        <translation>导出调色板…</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>全部移除</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message>
        <source>The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg or pfm numbered pictures, such as frame%04d.png.</source>
        <translation>扩展名决定格式：webm 或 mp4 为视频，webp 为动画，png、tiff、exr、jpg 或 pfm 为带编号的图片，例如 frame%04d.png。</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> 帧/秒</translation>
    </message>
    <message>
        <source>How many pictures a second the film has</source>
        <translation>影片每秒的图片数</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>How long the film is; the painting&apos;s time is stretched over it.</source>
        <translation>影片的时长；画作的时间会伸缩到此长度。</translation>
    </message>
    <message>
        <source>Animated WebP: begins anew at its end. Players decide it for videos.</source>
        <translation>WebP 动画：播放到结尾后重新开始。视频是否循环由播放器决定。</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>Numbered pictures</source>
        <translation>带编号的图片</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 帧</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>A film of %1 frames is too long. Choose a lower rate or a shorter length.</source>
        <translation>%1 帧的影片太长。请选择较低的帧率或较短的时长。</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Writing the film…</source>
        <translation>正在写入影片…</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1；剩余 %n 秒</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1；剩余 %n 分钟</numerusform>
        </translation>
    </message>
    <message>
        <source>Longest pause</source>
        <translation>最长停顿</translation>
    </message>
    <message>
        <source>Pauses in which nothing is painted or spreads are cut to this, in the painting&apos;s time.</source>
        <translation>没有绘制也没有扩散的停顿会缩短到此长度，以画作的时间计。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环播放</translation>
    </message>
    <message>
        <source>Export Timelapse</source>
        <translation>导出缩时视频</translation>
    </message>
    <message>
        <source>“%1” has no ending of a film or a picture. Choose one of: %2.</source>
        <translation>“%1”没有影片或图片的扩展名。请选择：%2。</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePanel</name>
    <message>
        <source>%1 is out of range: 0.1 to 1000 times is possible.</source>
        <translation>%1 超出范围：可为 0.1 到 1000 倍。</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end, when all has dried</source>
        <translation>当前所示的时刻，以及全部干透的结尾</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the painting is played: 0.1 to 1000 times as fast as it was painted</source>
        <translation>播放作画过程的速度：实际作画速度的 0.1 到 1000 倍</translation>
    </message>
    <message>
        <source>Show all of the time (0). Ctrl+wheel zooms.</source>
        <translation>显示全部时间 (0)。Ctrl+滚轮缩放。</translation>
    </message>
    <message>
        <source>Show all of the time</source>
        <translation>显示全部时间</translation>
    </message>
    <message>
        <source>Go to Its &amp;Start</source>
        <translation>转到其开头(&amp;S)</translation>
    </message>
    <message>
        <source>Go to When It Is Dr&amp;y</source>
        <translation>转到其干透时(&amp;Y)</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>绘制速度(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePointer</name>
    <message>
        <source>Stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message>
        <source>Drawn from %1 to %2</source>
        <translation>绘制于 %1 至 %2</translation>
    </message>
    <message>
        <source>Dry at %1</source>
        <translation>干透于 %1</translation>
    </message>
    <message>
        <source>Erased in part from %1 on</source>
        <translation>自 %1 起被部分擦除</translation>
    </message>
    <message>
        <source>Wetted again, dry at %1</source>
        <translation>再次润湿，干透于 %1</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>A bar for each stroke, from when it was painted until it is dry.</source>
        <translation>每条笔画一个条形，从绘制到干透。</translation>
    </message>
</context>
<context>
    <name>suffuse::TransformBar</name>
    <message>
        <source>X</source>
        <extracomment>left edge of the selection</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the selected strokes&apos; curves</source>
        <translation>所选笔画曲线的左边缘</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the selected strokes&apos; curves</source>
        <translation>所选笔画曲线的上边缘</translation>
    </message>
    <message>
        <source>W</source>
        <extracomment>width</extracomment>
        <translation>宽</translation>
    </message>
    <message>
        <source>Width of the selected strokes&apos; curves</source>
        <translation>所选笔画曲线的宽度</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>保持宽度与高度的比例</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>保持比例</translation>
    </message>
    <message>
        <source>H</source>
        <extracomment>height</extracomment>
        <translation>高</translation>
    </message>
    <message>
        <source>Height of the selected strokes&apos; curves</source>
        <translation>所选笔画曲线的高度</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Rotate the selected strokes by this angle</source>
        <translation>将所选笔画旋转此角度</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Some of these strokes would become too small, too large or too far away to be painted.</source>
        <translation>其中一些笔画会变得太小、太大或太远，无法绘制。</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlayLoader</name>
    <message>
        <source>Underlay</source>
        <translation>底图</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlaySection</name>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>A picture to paint over. It shows on the canvas only, never in what is exported.</source>
        <translation>供描绘参考的图片。只在画布上显示，绝不会出现在导出的结果中。</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>底图</translation>
    </message>
    <message>
        <source>Show the underlay</source>
        <translation>显示底图</translation>
    </message>
    <message>
        <source>Take the underlay out of the painting</source>
        <translation>从画作中移除底图</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the underlay shows.</source>
        <translation>底图显示的强弱。</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the underlay</source>
        <translation>底图的左边缘</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the underlay</source>
        <translation>底图的上边缘</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the underlay</source>
        <translation>底图的宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of the underlay</source>
        <translation>底图的高度</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>保持宽高比例</translation>
    </message>
    <message>
        <source>Fit to Canvas</source>
        <translation>适合画布</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it goes</source>
        <translation>在画布正中，尽可能大</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>替换…</translation>
    </message>
    <message>
        <source>Another picture in its place</source>
        <translation>用另一张图片替换</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>导入底图</translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>From one visible edge of the paint to the other, at its widest, as it is now</source>
        <translation>颜料从一侧可见边缘到另一侧的宽度，取最宽处，按当前时刻</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>整体</translation>
    </message>
    <message>
        <source>All that is selected</source>
        <translation>所有选中的内容</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>The segment under the pointer alone</source>
        <translation>只有指针下的线段</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>更改宽度</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 个笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, segment %2</source>
        <translation>%1，线段 %2</translation>
    </message>
</context>
<context>
    <name>suffuse::ShapeTool</name>
    <message>
        <source>Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.</source>
        <translation>从中心拖到一个角。Shift：按 15° 步进。回车：与上一个相同。</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.</source>
        <translation>从一角拖到对角。Shift：等边。Ctrl：从中心。回车：与上一个相同。</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>绘制的形状</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>圆角半径</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角数</translation>
    </message>
    <message>
        <source>Radius of the corners; half of the shorter side is the most</source>
        <translation>圆角半径；最大为短边的一半</translation>
    </message>
    <message>
        <source>How many corners a polygon, or tips a star has</source>
        <translation>多边形的角数或星形的尖数</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>内径</translation>
    </message>
    <message>
        <source>Radius of the inner corners, as a share of that of the tips</source>
        <translation>内角半径，占外角半径的比例</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆化</translation>
    </message>
    <message>
        <source>How much of each side is round</source>
        <translation>每条边被圆化的比例</translation>
    </message>
    <message>
        <source>From</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Where the arc begins, clockwise from the right</source>
        <translation>弧的起点，从右侧起顺时针</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>弧长</translation>
    </message>
    <message>
        <source>How far the arc goes round; 360° is the whole ellipse</source>
        <translation>弧的角度；360° 为整个椭圆</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>An arc is closed through the middle; else by a straight line</source>
        <translation>弧经中心闭合；否则用直线闭合</translation>
    </message>
</context>
<context>
    <name>suffuse::FillSection</name>
    <message>
        <source>How fast the fill spreads: the spread grows with the root of D times time. 0 keeps its edge crisp at any zoom.</source>
        <translation>填充扩散的快慢：扩散范围随 D 与时间乘积的平方根增长。0 使其边缘在任何缩放下保持清晰。</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>密度 ρ</translation>
    </message>
    <message>
        <source>Density ρ deep within the fill. On its outline it is half of that, so that with 1 and a threshold of ½ the paint ends there.</source>
        <translation>填充深处的密度 ρ。在轮廓上为其一半，因此取 1 且阈值为 ½ 时颜料止于轮廓。</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>What the stroke encloses was wetted at once, and spreads like its paint</source>
        <translation>笔画围住的区域一次被润湿，并像其颜料一样扩散</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>All that is enclosed</source>
        <translation>所有围住的区域</translation>
    </message>
    <message>
        <source>Every other area</source>
        <translation>隔一的区域</translation>
    </message>
    <message>
        <source>What is inside where the outline overlaps itself (nonzero and even-odd in SVG)</source>
        <translation>轮廓自相重叠处何为内部（SVG 的 nonzero 与 even-odd）</translation>
    </message>
    <message>
        <source>Change fill</source>
        <translation>更改填充</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>移除填充</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于所有选中对象：某个值会超出范围。</translation>
    </message>
</context>
<context>
    <name>suffuse::VaryDialog</name>
    <message>
        <source>Vary at Random</source>
        <translation>随机变化</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>随机变化</translation>
    </message>
    <message>
        <source>D becomes greater by up to this, or smaller by the same factor</source>
        <translation>D 最多增大此值，或按相同倍数减小</translation>
    </message>
    <message>
        <source>φ becomes greater by up to this, or smaller by the same factor</source>
        <translation>φ 最多增大此值，或按相同倍数减小</translation>
    </message>
    <message>
        <source>t_max becomes greater by up to this, or smaller by the same factor</source>
        <translation>t_max 最多增大此值，或按相同倍数减小</translation>
    </message>
    <message>
        <source>So much more grain, or less</source>
        <translation>颗粒最多增减此值</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Colours turn by up to this angle, either way</source>
        <translation>颜色最多向任一方向旋转此角度</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>Colours get lighter or darker by up to this</source>
        <translation>颜色最多变亮或变暗此值</translation>
    </message>
    <message>
        <source>So much more opaque, or less</source>
        <translation>不透明度最多增减此值</translation>
    </message>
    <message>
        <source>Roll Again</source>
        <translation>重新随机</translation>
    </message>
    <message>
        <source>Other random values by the same amounts</source>
        <translation>以相同幅度生成另一组随机值</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>每条笔画</translation>
    </message>
    <message>
        <source>Each segment</source>
        <translation>每个线段</translation>
    </message>
    <message>
        <source>Along each stroke</source>
        <translation>沿每条笔画</translation>
    </message>
    <message>
        <source>What gets a random value of its own; along a stroke values drift smoothly</source>
        <translation>哪些对象各有随机值；沿笔画时数值平滑漂移</translation>
    </message>
    <message>
        <source>Of its own</source>
        <translation>各自</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Over this length along a stroke values become others</source>
        <translation>沿笔画经过此长度后数值发生变化</translation>
    </message>
</context>
<context>
    <name>suffuse::WishFields</name>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>What is painted onto the segments</source>
        <translation>绘制到线段上的内容</translation>
    </message>
    <message>
        <source>Towards a value, or from the value that each segment has</source>
        <translation>趋向某个值，或以各线段现有的值为基础</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>What a segment has when it got all of it</source>
        <translation>线段被完全涂满后所具有的值</translation>
    </message>
    <message>
        <source>set to</source>
        <translation>设为</translation>
    </message>
    <message>
        <source>multiply by</source>
        <translation>乘以</translation>
    </message>
    <message>
        <source>add</source>
        <translation>加上</translation>
    </message>
    <message>
        <source>the current colour</source>
        <translation>当前颜色</translation>
    </message>
</context>
<context>
    <name>suffuse::GradientRows</name>
    <message>
        <source>Gradient</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>The fill&apos;s colour fades from left to right. The Segments tool drags the ends.</source>
        <translation>填充的颜色从左到右渐隐。可用“线段”工具拖动两端。</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>添加渐变</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>交换</translation>
    </message>
    <message>
        <source>The two colours change places</source>
        <translation>两种颜色互换位置</translation>
    </message>
    <message>
        <source>Swap colours of gradient</source>
        <translation>交换渐变的颜色</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>The fill has its first colour everywhere</source>
        <translation>填充各处均为第一种颜色</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>移除渐变</translation>
    </message>
    <message>
        <source>The second colour of the gradient</source>
        <translation>渐变的第二种颜色</translation>
    </message>
    <message>
        <source>Change gradient</source>
        <translation>更改渐变</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于全部所选内容：某个值会超出范围。</translation>
    </message>
</context>
<context>
    <name>ColourPicker</name>
    <message>
        <source>Beside the canvas there is no paint to take a colour from, unless paint beyond the canvas is shown.</source>
        <translation>画布之外没有可拾取的颜料，除非已显示画布外的颜料。</translation>
    </message>
</context>
<context>
    <name>GradientHandles</name>
    <message>
        <source>Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.</source>
        <translation>拖动渐变的一端。Ctrl：以 15° 为步长。点击它：颜色用于这一端。</translation>
    </message>
    <message>
        <source>Move gradient</source>
        <translation>移动渐变</translation>
    </message>
</context>
<context>
    <name>suffuse::PenTool</name>
    <message>
        <source>Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.</source>
        <translation>点击：尖角。拖动：曲线，Alt：只移动一个控制柄。首节点：闭合。回车：结束。退格：撤回一个。</translation>
    </message>
    <message>
        <source>Click or drag to go on with the selected stroke from its end.</source>
        <translation>点击或拖动，从所选笔画的端点继续。</translation>
    </message>
    <message>
        <source>Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.</source>
        <translation>点击为尖角，拖动为曲线。Shift：以 15° 为步长。所选笔画的端点：继续该笔画。</translation>
    </message>
    <message>
        <source>Extend outline</source>
        <translation>延长轮廓</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
</context>
<context>
    <name>suffuse::LassoFillTool</name>
    <message>
        <source>Click: straight line. First point, double click or Return: close. Shift: steps of 15°.</source>
        <translation>点击：直线。首点、双击或回车：闭合。Shift：以 15° 为步长。</translation>
    </message>
    <message>
        <source>Draw around what is to be filled. Alt at the end, or clicks: straight lines.</source>
        <translation>圈出要填充的区域。结束时按 Alt 或点击：直线。</translation>
    </message>
    <message>
        <source>Lasso fill</source>
        <translation>套索填充</translation>
    </message>
</context>
<context>
    <name>suffuse::BucketTool</name>
    <message>
        <source>Click: fill what the paint around that place bounds, with the brush in hand.</source>
        <translation>点击：用手中的画笔填充该处周围颜料所围住的区域。</translation>
    </message>
    <message>
        <source>Over all strokes</source>
        <translation>在所有笔画之上</translation>
    </message>
    <message>
        <source>Under all strokes</source>
        <translation>在所有笔画之下</translation>
    </message>
    <message>
        <source>Where the fill lies</source>
        <translation>填充的位置</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>By how much colours may differ from that under the pointer</source>
        <translation>颜色可与指针处相差多少</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Openings of the bounds that are narrower are closed</source>
        <translation>边界上更窄的开口视为闭合</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>扩大</translation>
    </message>
    <message>
        <source>How far the fill reaches under its bounds</source>
        <translation>填充伸入边界之下多远</translation>
    </message>
    <message>
        <source>Only what lies on the canvas is filled.</source>
        <translation>只填充画布上的区域。</translation>
    </message>
    <message>
        <source>There is nothing to fill here.</source>
        <translation>此处没有可填充的区域。</translation>
    </message>
    <message>
        <source>Bucket fill</source>
        <translation>油漆桶填充</translation>
    </message>
    <message>
        <source>Looking for what the paint bounds there. Esc gives it up.</source>
        <translation>正在查找颜料围住的区域。按 Esc 放弃。</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile: nothing was filled.</source>
        <translation>画作在此期间已改变：没有填充任何内容。</translation>
    </message>
</context>
<context>
    <name>suffuse::TextEntry</name>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
</context>
<context>
    <name>suffuse::TextTool</name>
    <message>
        <source>Something in this text is locked: unlock it to change the text.</source>
        <translation>此文字中有内容被锁定：请先解锁再更改文字。</translation>
    </message>
    <message>
        <source>The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or type on: new letters are those of a font like it.</source>
        <translation>此处未安装字体“%1”，因此这些字保持原样。请在上方另选字体，或继续键入：新的字将使用相近的字体。</translation>
    </message>
    <message>
        <source>Type. Return: a new line. Esc or a click elsewhere: done.</source>
        <translation>键入文字。回车：换行。Esc 或点击别处：完成。</translation>
    </message>
    <message>
        <source>Click or Return: type a text, or in the text that is there.</source>
        <translation>点击或回车：键入文字，或在已有的文字中键入。</translation>
    </message>
</context>
<context>
    <name>suffuse::TextRow</name>
    <message>
        <source>Font</source>
        <translation>字体</translation>
    </message>
    <message>
        <source>Font: it is not installed here, and another one stands in</source>
        <translation>字体：此处未安装，由另一种字体代替</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>极细</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>细</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>中等</translation>
    </message>
    <message>
        <source>Semibold</source>
        <translation>半粗</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>粗</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>特粗</translation>
    </message>
    <message>
        <source>How strong the letters are</source>
        <translation>字的粗细</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>斜体</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>字号</translation>
    </message>
    <message>
        <source>The em of the font</source>
        <translation>字体的全身尺寸</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>字距</translation>
    </message>
    <message>
        <source>Room that is added between letters, of the size</source>
        <translation>字与字之间增加的间距，相对于字号</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>From one line to the next, of the size</source>
        <translation>从一行到下一行的距离，相对于字号</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>End</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Where lines lie: they begin at the text&apos;s place, are centred on it, or end there</source>
        <translation>各行的位置：从文字的位置开始、以其为中心或在该处结束</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>竖排</translation>
    </message>
    <message>
        <source>Lines run from top to bottom, and follow each other from right to left</source>
        <translation>每行从上到下，各行从右到左排列</translation>
    </message>
    <message>
        <source>On Selected Stroke</source>
        <translation>沿所选笔画</translation>
    </message>
    <message>
        <source>Set the text along the selected stroke, which it follows from then on</source>
        <translation>让文字沿所选笔画排列，此后跟随该笔画</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>拉直</translation>
    </message>
    <message>
        <source>Take the text off its curve</source>
        <translation>让文字脱离曲线</translation>
    </message>
</context>
<context>
    <name>suffuse::TextValues</name>
    <message>
        <source>Change text</source>
        <translation>更改文字</translation>
    </message>
</context>
<context>
    <name>suffuse::BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>正片叠底</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>滤色</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>变暗</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>变亮</translation>
    </message>
    <message>
        <source>Colour Dodge</source>
        <translation>颜色减淡</translation>
    </message>
    <message>
        <source>Colour Burn</source>
        <translation>颜色加深</translation>
    </message>
    <message>
        <source>Hard Light</source>
        <translation>强光</translation>
    </message>
    <message>
        <source>Soft Light</source>
        <translation>柔光</translation>
    </message>
    <message>
        <source>Difference</source>
        <comment>blend mode</comment>
        <translation>差值</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <comment>blend mode</comment>
        <translation>排除</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>饱和度</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>相加</translation>
    </message>
    <message>
        <source>Mask Below</source>
        <translation>遮罩下方</translation>
    </message>
    <message>
        <source>Erase Below</source>
        <translation>擦除下方</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>剪贴到下方</translation>
    </message>
    <message>
        <source>The group covers what lies below.</source>
        <translation>组覆盖下方的内容。</translation>
    </message>
    <message>
        <source>Darkens, as glazes and shadows do; white changes nothing.</source>
        <translation>像罩染和阴影一样变暗；白色不改变任何内容。</translation>
    </message>
    <message>
        <source>Lightens, as lights do that fall on one place; black changes nothing.</source>
        <translation>像照在同一处的光一样变亮；黑色不改变任何内容。</translation>
    </message>
    <message>
        <source>Multiplies where it is dark below, and screens where it is light there.</source>
        <translation>下方暗处正片叠底，亮处滤色。</translation>
    </message>
    <message>
        <source>Of each channel the darker value stays.</source>
        <translation>每个通道保留较暗的值。</translation>
    </message>
    <message>
        <source>Of each channel the lighter value stays.</source>
        <translation>每个通道保留较亮的值。</translation>
    </message>
    <message>
        <source>Brightens what lies below, strongly where the group is light.</source>
        <translation>提亮下方的内容，组越亮效果越强。</translation>
    </message>
    <message>
        <source>Deepens what lies below, strongly where the group is dark.</source>
        <translation>加深下方的内容，组越暗效果越强。</translation>
    </message>
    <message>
        <source>Multiplies where the group is dark, and screens where it is light.</source>
        <translation>组的暗处正片叠底，亮处滤色。</translation>
    </message>
    <message>
        <source>Darkens or lightens gently, as a diffuse light does.</source>
        <translation>像漫射光一样柔和地变暗或变亮。</translation>
    </message>
    <message>
        <source>How far both are apart; white inverts what lies below.</source>
        <translation>两者相差多少；白色使下方的内容反相。</translation>
    </message>
    <message>
        <source>As Difference, with less contrast.</source>
        <translation>与差值相同，但对比度较低。</translation>
    </message>
    <message>
        <source>The hue of the group, with saturation and luminosity of what lies below.</source>
        <translation>采用组的色相，以及下方内容的饱和度和明度。</translation>
    </message>
    <message>
        <source>The saturation of the group, with hue and luminosity of what lies below.</source>
        <translation>采用组的饱和度，以及下方内容的色相和明度。</translation>
    </message>
    <message>
        <source>Hue and saturation of the group, with the luminosity of what lies below: for tinting.</source>
        <translation>采用组的色相和饱和度，以及下方内容的明度：用于着色。</translation>
    </message>
    <message>
        <source>The luminosity of the group, with hue and saturation of what lies below.</source>
        <translation>采用组的明度，以及下方内容的色相和饱和度。</translation>
    </message>
    <message>
        <source>The sum of both, for glows (plus, linear dodge).</source>
        <translation>两者之和，用于发光效果（plus，线性减淡）。</translation>
    </message>
    <message>
        <source>The group is not seen itself: what lies below stays where the group covers, and goes elsewhere (destination-in).</source>
        <translation>组本身不可见：下方的内容只在组覆盖处保留，其他地方消失（destination-in）。</translation>
    </message>
    <message>
        <source>The group is not seen itself: it takes away what lies below where it covers (destination-out).</source>
        <translation>组本身不可见：在其覆盖处去除下方的内容（destination-out）。</translation>
    </message>
    <message>
        <source>The group is seen only where paint lies below it: for shading a shape without leaving it (source-atop).</source>
        <translation>组只在其下方有颜料处可见：用于给形状上阴影而不超出其范围（source-atop）。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupSection</name>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap in it do not show through each other.</source>
        <translation>组显示的强度。低于 100 % 时整体变淡：组内重叠的笔画不会互相透出。</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>更改组的不透明度</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>无法应用于全部所选内容：某个值会超出范围。</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>更改组的模式</translation>
    </message>
    <message>
        <source>Mix by itself</source>
        <translation>自行混合</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>组自行混合</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>组与下方混合</translation>
    </message>
    <message>
        <source>How the group&apos;s picture is put on what lies below. Any mode but Normal has its strokes mix by themselves first.</source>
        <translation>组的图像如何置于下方内容之上。除“正常”外，任何模式都会让组内笔画先自行混合。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>the mode that is chosen, and what it does</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The group&apos;s strokes mix among themselves, and their picture is put on what lies below. Otherwise they mix with what lies below as if there were no group.</source>
        <translation>组内笔画彼此混合，其图像再置于下方内容之上。否则它们与下方内容混合，就像没有组一样。</translation>
    </message>
    <message>
        <source>Clip to below</source>
        <translation>剪贴到下方</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>蒙版</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>淡彩</translation>
    </message>
    <message>
        <source>The group is seen only where the next thing below it in the same group is: for shading a shape without leaving it.</source>
        <translation>该组只在同一组内紧挨其下的对象所在之处可见：用于给形状上阴影而不超出它。</translation>
    </message>
    <message>
        <source>The group is not seen itself; what else is in the same group is seen only where it has paint.</source>
        <translation>该组本身不可见；同一组内的其他内容只在它有颜料的地方可见。</translation>
    </message>
    <message>
        <source>All strokes of the group are one, laid wet into wet: their densities add up, with one style and one mixing. Filled strokes, hidden ones and those of a mask within it stay by themselves.</source>
        <translation>该组的所有笔画合为一笔，湿画在湿上：密度相加，共用一种样式和一种混合。填充的笔画、隐藏的笔画以及其中蒙版的笔画保持独立。</translation>
    </message>
    <message>
        <source>There is nothing below it to clip to.</source>
        <translation>它下方没有可剪贴到的对象。</translation>
    </message>
    <message>
        <source>There is nothing beside it to mask.</source>
        <translation>它旁边没有可遮罩的内容。</translation>
    </message>
    <message>
        <source>It is in a wash already.</source>
        <translation>它已在一个淡彩组中。</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>A colour that marks the group for you, in lists. It is not seen in the picture.</source>
        <translation>在列表中为您标记该组的颜色。画面中看不到它。</translation>
    </message>
    <message>
        <source>Mark group</source>
        <translation>标记组</translation>
    </message>
    <message>
        <source>The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a mask.</source>
        <translation>该组无论如何都自行混合：因其不透明度或模式，或因它被剪贴或是蒙版。</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>The group is seen here, and left out of pictures and films that are exported: for sketches and pictures to paint over.</source>
        <translation>该组在此可见，但不出现在导出的图片和影片中：适用于草图和描摹用的图片。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupTag</name>
    <message>
        <source>None</source>
        <comment>mark of a group</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Red</source>
        <comment>mark of a group</comment>
        <translation>红色</translation>
    </message>
    <message>
        <source>Orange</source>
        <comment>mark of a group</comment>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Yellow</source>
        <comment>mark of a group</comment>
        <translation>黄色</translation>
    </message>
    <message>
        <source>Green</source>
        <comment>mark of a group</comment>
        <translation>绿色</translation>
    </message>
    <message>
        <source>Blue</source>
        <comment>mark of a group</comment>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>Violet</source>
        <comment>mark of a group</comment>
        <translation>紫色</translation>
    </message>
    <message>
        <source>Brown</source>
        <comment>mark of a group</comment>
        <translation>棕色</translation>
    </message>
    <message>
        <source>Grey</source>
        <comment>mark of a group</comment>
        <translation>灰色</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>%1: the linked picture is missing or has changed. Put it back, or link it anew in the Inspector.</source>
        <translation>%1：链接的图片不存在或已更改。请放回原处，或在检查器中重新链接。</translation>
    </message>
    <message>
        <source>the image of a picture is missing</source>
        <translation>缺少图片的图像</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图片</translation>
    </message>
</context>
<context>
    <name>LayeredFile</name>
    <message>
        <source>%1: Photoshop files have at most 2 GB. Choose a smaller size, or OpenRaster.</source>
        <translation>%1：Photoshop 文件最大为 2 GB。请选择较小的尺寸，或使用 OpenRaster。</translation>
    </message>
    <message>
        <source>%1: Photoshop files have at most %2 pixels a side. Choose a smaller size, or OpenRaster.</source>
        <translation>%1：Photoshop 文件每边最多 %2 像素。请选择较小的尺寸，或使用 OpenRaster。</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>组 %1</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>已停止；未写入任何内容</translation>
    </message>
    <message>
        <source>The file could not be packed.</source>
        <translation>无法打包该文件。</translation>
    </message>
</context>
<context>
    <name>ImageLayer</name>
    <message>
        <source>%1: the pictures of a painting may have %2 million pixels together, and this one would be too many. Scale it down, or remove another one.</source>
        <translation>%1：一幅画中的图片总共最多 %2 百万像素，加上这一幅会超出。请缩小它，或删除另一幅。</translation>
    </message>
    <message>
        <source>Import picture</source>
        <translation>导入图片</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>The picture of the clipboard cannot be read.</source>
        <translation>无法读取剪贴板中的图片。</translation>
    </message>
    <message>
        <source>Paste picture</source>
        <translation>粘贴图片</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>底图</translation>
    </message>
    <message>
        <source>Underlay to layer</source>
        <translation>底图转为图层</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>链接图片</translation>
    </message>
    <message>
        <source>Embed picture</source>
        <translation>嵌入图片</translation>
    </message>
    <message>
        <source>Reset proportions</source>
        <translation>重置比例</translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Linked to a file</source>
        <translation>链接到文件</translation>
    </message>
    <message>
        <source>The painting names the picture&apos;s file, and does not hold the picture itself. Otherwise the picture is in the painting, whatever becomes of the file.</source>
        <translation>画中只记录图片的文件，而不包含图片本身。否则图片保存在画中，与文件的变化无关。</translation>
    </message>
    <message>
        <source>Relink…</source>
        <translation>重新链接…</translation>
    </message>
    <message>
        <source>Another file, or the same one where it lies now, in the picture&apos;s place</source>
        <translation>用另一个文件，或同一文件的新位置，代替该图片</translation>
    </message>
    <message>
        <source>Reset Proportions</source>
        <translation>重置比例</translation>
    </message>
    <message>
        <source>As high and wide as its pixels ask for: its top left corner, its direction and its width stay.</source>
        <translation>按其像素的宽高比：左上角、方向和宽度保持不变。</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>链接图片</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n 幅图片</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is missing or has changed, and is not seen.</source>
        <translation>%1 不存在或已更改，因此不可见。</translation>
    </message>
    <message>
        <source>A picture is missing, and is not seen.</source>
        <translation>缺少一幅图片，因此不可见。</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>已中断；没有写入任何内容</translation>
    </message>
    <message>
        <source>the sheet is too large for a picture with a pixel a unit</source>
        <translation>画布太大，无法生成每单位一个像素的图像</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG 没有擦除下方内容的组：%n 个组变成了普通组。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>省略了 %n 个笔画，因为它们没有任何部分的覆盖足以形成路径。</numerusform>
        </translation>
    </message>
    <message>
        <source>The drawing differs from the picture by at most %1 of 255, by %2 on average.</source>
        <translation>图形与图像的差异最大为 %1（满值 255），平均为 %2。</translation>
    </message>
    <message>
        <source>%1: would have %2 MB once it is unpacked, and could not be opened again. Choose fewer bands, or the ending .svg.</source>
        <translation>%1：解压后将有 %2 MB，无法再次打开。请选择更少的条带，或使用 .svg 扩展名。</translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF 没有擦除下方内容或与之相加的组：%n 个组变成了普通组。</numerusform>
        </translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingDialog</name>
    <message>
        <source>One path for each stroke, where it is covered by half: for plotters, cutters, logos.</source>
        <translation>每个笔画一条路径，取覆盖一半之处：用于绘图仪、切割机、标志。</translation>
    </message>
    <message>
        <source>Contours within each other, as opaque as the paint. They look like the painting at any zoom.</source>
        <translation>层层嵌套的等值线，与颜料同样不透明。无论放大多少，看上去都与画作一样。</translation>
    </message>
    <message>
        <source>The exact picture, a pixel a unit, and over it the outlines without paint, to select and name strokes by.</source>
        <translation>精确的图像，每单位一个像素，上面是不着色的轮廓，便于选取和命名笔画。</translation>
    </message>
    <message>
        <source>Export Drawing</source>
        <translation>导出图形</translation>
    </message>
    <message>
        <source>The ending chooses the format: svg, svgz, which is packed, or pdf.</source>
        <translation>扩展名决定格式：svg、经过压缩的 svgz，或 pdf。</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>条带</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Picture and outlines</source>
        <translation>图像与轮廓</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>What of the painting becomes paths</source>
        <translation>画作的哪些内容成为路径</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>How many bands full opacity is drawn in. More of them are smoother, and make a larger file.</source>
        <translation>完全不透明分为多少条带。越多越平滑，文件也越大。</translation>
    </message>
    <message>
        <source>Of red, green and blue, over the sheet, with a pixel a unit</source>
        <translation>整个画布上红、绿、蓝的差异，每单位一个像素</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Comparing with the picture…</source>
        <translation>正在与图像比较…</translation>
    </message>
    <message>
        <source>It is exported as soon as it is compared with the picture.</source>
        <translation>与画面比较完后立即导出。</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>图形</translation>
    </message>
    <message>
        <source>“%1” has no ending of a drawing. Choose one of: %2.</source>
        <translation>“%1”没有图形的扩展名。请选择：%2。</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>与画面一样大</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where that is not said, has 96 units an inch.</source>
        <translation>用于 PDF：画纸放入页面并居中。不选页面时，画纸与纸上的大小相同；没有给出纸上大小时，每英寸 96 个单位。</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingJob</name>
    <message>
        <source>The drawing does not fit into memory.</source>
        <translation>图形太大，内存不足。</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ColourProfile</name>
    <message>
        <source>it is no ICC profile of RGB, grey or CMYK</source>
        <translation>不是 RGB、灰度或 CMYK 的 ICC 配置文件</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is too large</source>
        <translation>%1：无法读取，或文件过大</translation>
    </message>
</context>
<context>
    <name>suffuse::Proofing</name>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>校样的配置文件</translation>
    </message>
    <message>
        <source>Colours not converted</source>
        <translation>颜色未转换</translation>
    </message>
    <message>
        <source>Proof: %1</source>
        <translation>校样：%1</translation>
    </message>
</context>
<context>
    <name>ChooseProfile</name>
    <message>
        <source>Colour profiles</source>
        <translation>颜色配置文件</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPage</name>
    <message>
        <source>That of the system</source>
        <translation>系统的配置文件</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>无（sRGB）</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>来自文件</translation>
    </message>
    <message>
        <source>Screen profile</source>
        <translation>屏幕配置文件</translation>
    </message>
    <message>
        <source>What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were meant.</source>
        <translation>屏幕如何呈现其数值。画布会据此转换，使颜色看起来符合本意。</translation>
    </message>
    <message>
        <source>Screen profile file</source>
        <translation>屏幕配置文件的文件</translation>
    </message>
    <message>
        <source>Chooses the ICC profile that was measured for this screen</source>
        <translation>选择为此屏幕测得的 ICC 配置文件</translation>
    </message>
    <message>
        <source>Soft proof</source>
        <translation>色彩校样</translation>
    </message>
    <message>
        <source>Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left there.</source>
        <translation>选择印刷机或打印机的 ICC 配置文件。视图 ▸ 色彩校样会显示在那里还剩下的颜色。</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>感知</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>相对比色</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>饱和度</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>绝对比色</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>渲染意图</translation>
    </message>
    <message>
        <source>What becomes of colours that the device of the soft proof does not have</source>
        <translation>校样设备没有的颜色如何处理</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>黑点补偿</translation>
    </message>
    <message>
        <source>The darkest colour becomes the darkest one that the device has</source>
        <translation>最暗的颜色变为该设备最暗的颜色</translation>
    </message>
    <message>
        <source>Profile of the Screen</source>
        <translation>屏幕的配置文件</translation>
    </message>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>校样的配置文件</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
</context>
<context>
    <name>suffuse::ProfileBox</name>
    <message>
        <source>The painting&apos;s profile</source>
        <translation>绘画的配置文件</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>来自文件…</translation>
    </message>
    <message>
        <source>%1: the profile is too large to be kept in a painting. Choose a smaller one.</source>
        <translation>%1：该配置文件太大，无法保存在绘画中。请选择较小的。</translation>
    </message>
    <message>
        <source>%1: %2. Choose a profile of RGB colours.</source>
        <translation>%1：%2。请选择 RGB 颜色的配置文件。</translation>
    </message>
    <message>
        <source>Profile of the Colours</source>
        <translation>颜色的配置文件</translation>
    </message>
</context>
<context>
    <name>suffuse::FitJob</name>
    <message>
        <source>%1: there is not enough memory to fit it.</source>
        <translation>%1：内存不足，无法将其转为笔画。</translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message>
        <source>Ground</source>
        <translation>底色</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Picture to strokes</source>
        <translation>图片转为笔画</translation>
    </message>
    <message>
        <source>The picture was painted quickly, just before the moment that you look at. All that you painted stays as it is.</source>
        <translation>图画已快速画在您正在看的时刻之前。您画过的一切保持原样。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>加入了 %Ln 条笔画，其下有一层底色。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitView</name>
    <message>
        <source>Picture made of strokes</source>
        <translation>由笔画组成的图片</translation>
    </message>
    <message>
        <source>What the strokes look like. While a mouse button is held on it, the original is seen.</source>
        <translation>笔画的样子。在其上按住鼠标键时显示原图。</translation>
    </message>
    <message>
        <source>Here the picture grows, stroke by stroke.</source>
        <translation>图片将在这里一笔一笔地生长。</translation>
    </message>
</context>
<context>
    <name>suffuse::FitRows</name>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>At most so many. More of them go on with those that are there; fewer begin anew.</source>
        <translation>最多这么多。增加时在现有笔画上继续；减少时重新开始。</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>精细度</translation>
    </message>
    <message>
        <source>How much is done for each stroke. Better goes on with what is there.</source>
        <translation>为每一笔所做的计算量。提高时在现有基础上继续。</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Of all strokes. Another one begins anew.</source>
        <translation>所有笔画的样式。更换后重新开始。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Each stroke its own, or a few paints, which become linked swatches</source>
        <translation>每笔各有颜色，或使用少数几种颜料（成为链接的色板）</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Few paints</source>
        <translation>少数颜料</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>颜料数</translation>
    </message>
    <message>
        <source>So many colours in all</source>
        <translation>颜色总数</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Widths of strokes, and the roll of the dice</source>
        <translation>笔画宽度和随机数</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>最小宽度</translation>
    </message>
    <message>
        <source>No stroke is narrower; 0: as narrow as it likes</source>
        <translation>没有更窄的笔画；0：不限</translation>
    </message>
    <message>
        <source>Greatest width</source>
        <translation>最大宽度</translation>
    </message>
    <message>
        <source>No stroke is wider; 0: as wide as it likes</source>
        <translation>没有更宽的笔画；0：不限</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Another number gives other strokes, equally good ones</source>
        <translation>换一个数会得到另一组同样好的笔画</translation>
    </message>
    <message>
        <source>The greatest width is below the least one.</source>
        <translation>最大宽度小于最小宽度。</translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message>
        <source>far: %1 dB</source>
        <translation>相差较远：%1 dB</translation>
    </message>
    <message>
        <source>roughly: %1 dB</source>
        <translation>大致相似：%1 dB</translation>
    </message>
    <message>
        <source>near: %1 dB</source>
        <translation>接近：%1 dB</translation>
    </message>
    <message>
        <source>very near: %1 dB</source>
        <translation>非常接近：%1 dB</translation>
    </message>
    <message>
        <source>Picture to Strokes</source>
        <translation>图片转为笔画</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>进展</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>原图</translation>
    </message>
    <message>
        <source>Shows the picture itself: while held, or click to switch back and forth.</source>
        <translation>显示原图：按住时显示，或点击来回切换。</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Which picture becomes strokes</source>
        <translation>哪张图片转为笔画</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>底图</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>插入(&amp;I)</translation>
    </message>
    <message>
        <source>Puts the strokes so far into the painting, as a layer</source>
        <translation>将目前的笔画作为图层放入画作</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the work, or goes on with it</source>
        <translation>停止或继续计算</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>正在读取图片…</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 笔</numerusform>
        </translation>
    </message>
    <message>
        <source>off by %1 of 255</source>
        <translation>相差 %1/255</translation>
    </message>
    <message>
        <source>Fewer Strokes</source>
        <translation>减少笔画</translation>
    </message>
    <message>
        <source>What the strokes are to look like: as those that are there do, or as a picture of the whole sheet</source>
        <translation>笔画应有的样子：与现有笔画相同，或像一张整个画布的图片</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>保持外观</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>Puts the strokes so far in place of the selected ones</source>
        <translation>用目前的笔画替换所选笔画</translation>
    </message>
    <message>
        <source>Give up the strokes so far?</source>
        <translation>放弃目前的笔画？</translation>
    </message>
    <message>
        <source>Replace puts them in place of the selected ones.</source>
        <translation>“替换”会用它们代替选中的笔画。</translation>
    </message>
    <message>
        <source>Insert puts them into the painting.</source>
        <translation>“插入”会把它们放进画作。</translation>
    </message>
    <message>
        <source>&amp;Give Up</source>
        <translation>放弃(&amp;G)</translation>
    </message>
</context>
<context>
    <name>fitting</name>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>%1: is black all over, so nothing counts; paint white what is to be fitted</source>
        <translation>%1：全为黑色，没有可计入之处；请把要拟合的部分涂白</translation>
    </message>
    <message>
        <source>its canvas has %1 × %2 units, and the picture %3 × %4 pixels; go on with a painting that was fitted to this picture</source>
        <translation>其画布为 %1 × %2 单位，而图片为 %3 × %4 像素；请使用由此图片拟合的画作继续</translation>
    </message>
    <message>
        <source>stroke %1: %2; a fit goes on with what a fit made</source>
        <translation>笔画 %1：%2；只能从拟合得到的画作继续</translation>
    </message>
</context>
<context>
    <name>curves</name>
    <message>
        <source>its picture has %1 × %2 pixels; image_width and image_height must be 1 at least</source>
        <translation>其图片为 %1 × %2 像素；image_width 和 image_height 至少要为 1</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to solve</source>
        <translation>不含曲线；没有可求解的内容</translation>
    </message>
</context>
<context>
    <name>refit</name>
    <message>
        <source>none of the strokes is visible and unlocked; choose others</source>
        <translation>没有一条笔画是可见且未锁定的；请选择其他笔画</translation>
    </message>
    <message>
        <source>the strokes lie beside the sheet, where nothing is seen of them</source>
        <translation>笔画位于画布之外，看不到它们</translation>
    </message>
    <message>
        <source>the strokes of group “%1” mix in their own way; choose all of them that are visible, or none of them</source>
        <translation>组“%1”的笔画以自己的方式混合；请选择其中所有可见的笔画，或一条也不选</translation>
    </message>
    <message>
        <source>group “%1” is a wash, whose strokes are one; make it a group like others first</source>
        <translation>组“%1”是淡彩，其笔画合为一体；请先把它变成普通的组</translation>
    </message>
    <message>
        <source>%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape of the sheet</source>
        <translation>%1：形状为 %2 × %3，而画布为 %4 × %5；请把它裁剪成画布的形状</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>the strokes are in a group that is put on the others as one picture, so no picture of the whole says how they should look; make it a group like others first</source>
        <translation>这些笔画所在的组是作为一整张图叠在其他笔画上的，因此整体图片无法说明它们应有的样子；请先把它变成普通的组</translation>
    </message>
    <message>
        <source>other strokes hide the chosen ones wholly; choose others, or hide what lies above</source>
        <translation>其他笔画完全遮住了所选笔画；请选择其他笔画，或隐藏上方的内容</translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message>
        <source>There the picture is off by %1 of 255 (root mean square), %2 at most.</source>
        <translation>该处画面相差 %1/255（均方根），最多 %2。</translation>
    </message>
    <message>
        <source>Fewer strokes</source>
        <translation>减少笔画</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>代替 %Ln 条。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>原先夹在其间的 %Ln 条笔画现在位于下方。</numerusform>
        </translation>
    </message>
    <message>
        <source>That is farther than before, when it was off by %1; Undo brings the former strokes back.</source>
        <translation>这比原来的 %1 差得更多；撤销可恢复原来的笔画。</translation>
    </message>
</context>
<context>
    <name>Tiles</name>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start again to go on.</source>
        <translation>%1 其他后端绘制的比特不同，不会混入。请重新启动以继续。</translation>
    </message>
    <message>
        <source>there is not enough memory for the sheets that are drawn at once</source>
        <translation>内存不足，无法容纳同时绘制的部分</translation>
    </message>
    <message>
        <source>a tile cannot be encoded: %1</source>
        <translation>无法编码图块：%1</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2)</source>
        <translation>%1：无法读取（%2）</translation>
    </message>
    <message>
        <source>%1: what is there is of another picture, or of another build or backend. Remove it, or choose another name.</source>
        <translation>%1：已有内容属于另一幅图像，或来自另一构建或后端。请将其删除，或选择另一个名称。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1：无法写入（%2）。请选择另一个文件夹，或更改其权限。</translation>
    </message>
    <message>
        <source>%1: another program is drawing the same picture. Wait until it has finished, or choose another name.</source>
        <translation>%1：另一个程序正在绘制同一图像。请等它完成，或选择另一个名称。</translation>
    </message>
</context>
<context>
    <name>suffuse::ManualWindow</name>
    <message>
        <source>Suffuse Manual</source>
        <translation>Suffuse 手册</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>没有找到</translation>
    </message>
</context>
<context>
    <name>suffuse::Lesson</name>
    <message>
        <source>Paint, and change your mind</source>
        <translation>画一笔，再改主意</translation>
    </message>
    <message>
        <source>Let paint spread</source>
        <translation>让颜料扩散</translation>
    </message>
    <message>
        <source>Work with layers</source>
        <translation>使用图层</translation>
    </message>
    <message>
        <source>Done. All of this can be changed at any time.</source>
        <translation>完成。这一切随时都可以再改。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke on the sheet, however you like.</source>
        <translation>按 B，在画纸上随意画一笔。</translation>
    </message>
    <message>
        <source>Press V for the Select tool, and click the paint of your stroke.</source>
        <translation>按 V 拿起选择工具，点击这条笔画的颜料。</translation>
    </message>
    <message>
        <source>Choose another colour in the Colour dock. It is now about what is selected.</source>
        <translation>在颜色面板里选另一种颜色。它现在针对所选内容。</translation>
    </message>
    <message>
        <source>Take it back with Ctrl+Z.</source>
        <translation>用 Ctrl+Z 撤销。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. Watch it spread after you let go.</source>
        <translation>按 B 画一笔。松开后看它继续扩散。</translation>
    </message>
    <message>
        <source>Press D: this goes to the moment when everything is dry.</source>
        <translation>按 D：跳到全部干透的时刻。</translation>
    </message>
    <message>
        <source>In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far.</source>
        <translation>在检查器面板里拖动扩散系数 D 的滑块。干了的颜料会扩散得更远或更近。</translation>
    </message>
    <message>
        <source>Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it.</source>
        <translation>选择“图层 ▸ 新建图层”，或按 Ctrl+Shift+N。接下来画的会进入其中。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. The layer comes into the list with it.</source>
        <translation>按 B 画一笔。图层随之出现在列表中。</translation>
    </message>
    <message>
        <source>In the row of the layer, drag its opacity to the left, or click its mode and choose another one.</source>
        <translation>在图层所在的行里把不透明度向左拖，或者点击模式另选一种。</translation>
    </message>
</context>
<context>
    <name>suffuse::LessonCard</name>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – 第 %2 步，共 %3 步</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>离开课程</translation>
    </message>
</context>
<context>
    <name>suffuse::Sheets</name>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 毫米</translation>
    </message>
    <message>
        <source>%1 × %2 in</source>
        <translation>%1 × %2 英寸</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>纸张</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>草图</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>全高清</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>美式信纸</translation>
    </message>
    <message>
        <source>Legal</source>
        <translation>美式法律用纸</translation>
    </message>
    <message>
        <source>Tabloid</source>
        <translation>美式小报</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>明信片</translation>
    </message>
    <message>
        <source>Watercolour sheet</source>
        <translation>水彩纸</translation>
    </message>
    <message>
        <source>Rice paper</source>
        <translation>宣纸</translation>
    </message>
    <message>
        <source>Toned paper</source>
        <translation>有色纸</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>夜色</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>油画布</translation>
    </message>
</context>
<context>
    <name>suffuse::WelcomeDialog</name>
    <message>
        <source>Welcome to Suffuse</source>
        <translation>欢迎使用 Suffuse</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>新画作</translation>
    </message>
    <message>
        <source>Other Size…</source>
        <translation>其他尺寸…</translation>
    </message>
    <message>
        <source>Open a painting</source>
        <translation>打开画作</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>三节短课</translation>
    </message>
    <message>
        <source>Show this at the start</source>
        <translation>启动时显示</translation>
    </message>
    <message>
        <source>Sheets by their size. Return begins a painting on one.</source>
        <translation>按尺寸排列的画纸。按回车键开始绘画。</translation>
    </message>
    <message>
        <source>Recent paintings and samples. Return opens one.</source>
        <translation>最近的画作和示例。按回车键打开。</translation>
    </message>
</context>
<context>
    <name>suffuse::Workspaces</name>
    <message>
        <source>Save Workspace</source>
        <translation>保存工作区</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>There is a workspace “%1” already.</source>
        <translation>已有名为“%1”的工作区。</translation>
    </message>
    <message>
        <source>It would be replaced by how the window is arranged now.</source>
        <translation>它将被窗口现在的布局替换。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>The workspace “%1” was saved: View ▸ Workspaces.</source>
        <translation>工作区“%1”已保存：视图 ▸ 工作区。</translation>
    </message>
    <message>
        <source>The workspace “%1” is damaged. Save it anew.</source>
        <translation>工作区“%1”已损坏，请重新保存。</translation>
    </message>
    <message>
        <source>&amp;Delete Workspace</source>
        <translation>删除工作区(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the workspace “%1”?</source>
        <translation>删除工作区“%1”吗？</translation>
    </message>
    <message>
        <source>The window stays arranged as it is.</source>
        <translation>窗口保持现在的布局。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferencePanel</name>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Choose a picture to look at while painting</source>
        <translation>选择绘画时参考的图片</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合</translation>
    </message>
    <message>
        <source>Show all of the picture</source>
        <translation>显示整张图片</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>A pixel of the picture is one of the screen</source>
        <translation>图片的一个像素对应屏幕的一个像素</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Show no picture here; its file stays</source>
        <translation>这里不再显示图片；文件不受影响</translation>
    </message>
    <message>
        <source>Open Reference Picture</source>
        <translation>打开参考图片</translation>
    </message>
    <message>
        <source>Actual pixels</source>
        <translation>实际像素</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferenceView</name>
    <message>
        <source>Reference picture</source>
        <translation>参考图片</translation>
    </message>
    <message>
        <source>Arrow keys move a cross, and Return picks the colour there.</source>
        <translation>方向键移动十字，回车键取那里的颜色。</translation>
    </message>
    <message>
        <source>Drop a picture here to look at it while you paint, and to take colours from it.</source>
        <translation>把图片拖到这里，绘画时可以参考它并从中取色。</translation>
    </message>
</context>
<context>
    <name>suffuse::ViewWindow</name>
    <message>
        <source>View of the painting</source>
        <translation>画作的视图</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>%1 · view at %2 %</source>
        <translation>%1 · 视图 %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: install bubblewrap, and they have no network and can write nowhere else.</source>
        <translation>程序在时间、内存和写入量上受到限制，但未被隔离：请安装 bubblewrap，之后它们没有网络，也不能写入其他位置。</translation>
    </message>
    <message>
        <source>Programs are confined by bubblewrap: they have no network, unless they say that they need it, and can write in a temporary folder only.</source>
        <translation>程序由 bubblewrap 隔离：除非声明需要，否则没有网络，并且只能在临时文件夹中写入。</translation>
    </message>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: bubblewrap is installed, and does not work here (%1).</source>
        <translation>程序在时间、内存和写入量上受到限制，但未被隔离：bubblewrap 已安装，但在此处无法工作（%1）。</translation>
    </message>
    <message>
        <source>it wrote no result</source>
        <translation>它没有写出结果</translation>
    </message>
    <message>
        <source>its result cannot be read</source>
        <translation>其结果无法读取</translation>
    </message>
    <message>
        <source>its result is no file</source>
        <translation>其结果不是文件</translation>
    </message>
    <message>
        <source>its result is too large</source>
        <translation>其结果过大</translation>
    </message>
    <message>
        <source>its result is empty</source>
        <translation>其结果为空</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected. Select strokes first.</source>
        <translation>没有选中可见且未锁定的内容。请先选择笔画。</translation>
    </message>
    <message>
        <source>Nothing in the layer is visible and unlocked.</source>
        <translation>图层中没有可见且未锁定的内容。</translation>
    </message>
    <message>
        <source>No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>无法创建临时文件夹：%1。请将 TMPDIR 设为可写入的文件夹。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is the disk full?</source>
        <translation>%1：无法写入（%2）。磁盘是否已满？</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2.</source>
        <translation>无法启动程序 %1：%2。</translation>
    </message>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>它在 %n 秒后被终止，这是允许的最长时间。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was ended, since it took more than %1 MB of memory.</source>
        <translation>它被终止，因为占用了超过 %1 MB 的内存。</translation>
    </message>
    <message>
        <source>It was ended, since it wrote more than %1 MB.</source>
        <translation>它被终止，因为写入了超过 %1 MB。</translation>
    </message>
    <message>
        <source>The program was killed or crashed. The painting is as it was.</source>
        <translation>程序被终止或已崩溃。画作保持原样。</translation>
    </message>
    <message>
        <source>The program failed (exit code %1). The painting is as it was.</source>
        <translation>程序失败（退出码 %1）。画作保持原样。</translation>
    </message>
    <message>
        <source>It wrote: %1</source>
        <translation>它写道：%1</translation>
    </message>
    <message>
        <source>Its result is not used, and the painting is as it was: %1.</source>
        <translation>其结果未被采用，画作保持原样：%1。</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 未被写入：%2。</translation>
    </message>
    <message>
        <source>a colour is red, yellow, blue and opacity, each from 0 to 1</source>
        <translation>颜色由红、黄、蓝和不透明度组成，各为 0 到 1</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>请给出一个数</translation>
    </message>
    <message>
        <source>%1 is not in [%2, %3]</source>
        <translation>%1 不在 [%2, %3] 内</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 不是整数</translation>
    </message>
    <message>
        <source>“%1” is none of %2</source>
        <translation>“%1”不是 %2 之一</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>请给出 true 或 false</translation>
    </message>
    <message>
        <source>give a text of at most %1 characters</source>
        <translation>请给出至多 %1 个字符的文本</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>请选择文件</translation>
    </message>
    <message>
        <source>%1: the name must end with .%2</source>
        <translation>%1：文件名须以 .%2 结尾</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1：没有这个文件</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1：没有这个文件夹</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>“%1”不是数</translation>
    </message>
    <message>
        <source>“%1” is neither true nor false</source>
        <translation>“%1”既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is larger than 1 MB</source>
        <translation>%1：无法读取，或大于 1 MB</translation>
    </message>
    <message>
        <source>%1: %2 has the id “%3”, too; give it another one</source>
        <translation>%1：%2 也使用标识“%3”；请换一个</translation>
    </message>
    <message>
        <source>Python 3 is missing. Install python3.</source>
        <translation>缺少 Python 3。请安装 python3。</translation>
    </message>
    <message>
        <source>The program %1 is missing, or cannot be started. Install it.</source>
        <translation>程序 %1 缺失或无法启动。请安装它。</translation>
    </message>
    <message>
        <source>%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and python3-numpy, or by pip as docs/python.md says.</source>
        <translation>%1 找不到 Python 模块 %2。请用 python3-suffuse、python3-numpy 之类的软件包安装，或按 docs/python.md 所述用 pip 安装。</translation>
    </message>
    <message>
        <source>name the program, and what it is started with</source>
        <translation>请指定程序及其启动参数</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>“%1” is not “%2”</source>
        <translation>“%1”不是“%2”</translation>
    </message>
    <message>
        <source>version %1 is not known; this program reads version %2</source>
        <translation>版本 %1 未知；本程序读取版本 %2</translation>
    </message>
    <message>
        <source>“%1” does not look like %2</source>
        <translation>“%1”不符合 %2</translation>
    </message>
    <message>
        <source>a text has 1 to 2000 characters</source>
        <translation>文本应有 1 到 2000 个字符</translation>
    </message>
    <message>
        <source>give a text, or one for each language</source>
        <translation>请给出一个文本，或每种语言各一个</translation>
    </message>
    <message>
        <source>give at most %1 texts of 1 to 4096 characters</source>
        <translation>请给出至多 %1 个 1 到 4096 个字符的文本</translation>
    </message>
    <message>
        <source>there are at most 3 submenus within each other</source>
        <translation>子菜单最多嵌套 3 层</translation>
    </message>
    <message>
        <source>there are at most %1 fields</source>
        <translation>至多 %1 个字段</translation>
    </message>
    <message>
        <source>two fields are called %1</source>
        <translation>两个字段都叫 %1</translation>
    </message>
    <message>
        <source>the field&apos;s type must stand before its default</source>
        <translation>字段的 type 必须写在 default 之前</translation>
    </message>
    <message>
        <source>there are at most %1 choices</source>
        <translation>至多 %1 个选项</translation>
    </message>
    <message>
        <source>is not above least</source>
        <translation>不大于 least</translation>
    </message>
    <message>
        <source>whole numbers are from -1000000000 to 1000000000</source>
        <translation>整数范围为 -1000000000 到 1000000000</translation>
    </message>
    <message>
        <source>“%1” is no ending; give it without its dot</source>
        <translation>“%1”不是扩展名；请去掉点号</translation>
    </message>
    <message>
        <source>a part of the painting was passed, so canvas, palette and underlay must stay as they are</source>
        <translation>传入的是画作的一部分，因此画布、调色板和底图必须保持不变</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>It went well.</source>
        <translation>运行成功。</translation>
    </message>
    <message>
        <source>The result does not fit into memory.</source>
        <translation>结果无法放入内存。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionDialog</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 已存在。要替换吗？</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>其现有内容将丢失。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>It was stopped. The painting is as it was.</source>
        <translation>已停止。画作保持原样。</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile, so the result is not used. Run it again.</source>
        <translation>画作在此期间已更改，因此结果未被采用。请再次运行。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionFields</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>选择文件夹和文件名</translation>
    </message>
</context>
<context>
    <name>suffuse::ManageExtensionsDialog</name>
    <message>
        <source>Manage Extensions</source>
        <translation>管理扩展</translation>
    </message>
    <message>
        <source>Extensions</source>
        <translation>扩展</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>扩展</translation>
    </message>
    <message>
        <source>From</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>About the extension</source>
        <translation>关于该扩展</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>打开文件夹(&amp;O)</translation>
    </message>
    <message>
        <source>Your own extensions lie there, each in a folder with a manifest</source>
        <translation>您自己的扩展位于其中，每个都在带有清单的文件夹中</translation>
    </message>
    <message>
        <source>Read &amp;Again</source>
        <translation>重新读取(&amp;A)</translation>
    </message>
    <message>
        <source>Looks for extensions anew, after files were changed</source>
        <translation>文件更改后重新查找扩展</translation>
    </message>
    <message>
        <source>You</source>
        <translation>您</translation>
    </message>
    <message>
        <source>Suffuse</source>
        <translation>Suffuse</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>无法使用</translation>
    </message>
    <message>
        <source>There are no extensions yet. Put a folder with a manifest into yours.</source>
        <translation>还没有扩展。请将带有清单的文件夹放入您的文件夹。</translation>
    </message>
    <message>
        <source>It uses the network.</source>
        <translation>它使用网络。</translation>
    </message>
    <message>
        <source>The last run: %1</source>
        <translation>上次运行：%1</translation>
    </message>
    <message>
        <source>Your extensions lie in %1.</source>
        <translation>您的扩展位于 %1。</translation>
    </message>
    <message>
        <source>What the chosen extension does, what is wrong with it, and what it wrote when it last ran</source>
        <translation>所选扩展的作用、其中的问题，以及上次运行时写出的内容</translation>
    </message>
    <message>
        <source>Those that are checked stand in the menu</source>
        <translation>已勾选的扩展显示在菜单中</translation>
    </message>
</context>
<context>
    <name>ColourWords</name>
    <message>
        <source>dark red</source>
        <translation>深红色</translation>
    </message>
    <message>
        <source>red</source>
        <translation>红色</translation>
    </message>
    <message>
        <source>light red</source>
        <translation>浅红色</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>棕色</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>light orange</source>
        <translation>浅橙色</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>橄榄色</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>黄色</translation>
    </message>
    <message>
        <source>light yellow</source>
        <translation>浅黄色</translation>
    </message>
    <message>
        <source>dark yellow-green</source>
        <translation>深黄绿色</translation>
    </message>
    <message>
        <source>yellow-green</source>
        <translation>黄绿色</translation>
    </message>
    <message>
        <source>light yellow-green</source>
        <translation>浅黄绿色</translation>
    </message>
    <message>
        <source>dark green</source>
        <translation>深绿色</translation>
    </message>
    <message>
        <source>green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>light green</source>
        <translation>浅绿色</translation>
    </message>
    <message>
        <source>dark turquoise</source>
        <translation>深青色</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>青色</translation>
    </message>
    <message>
        <source>light turquoise</source>
        <translation>浅青色</translation>
    </message>
    <message>
        <source>dark blue</source>
        <translation>深蓝色</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>浅蓝色</translation>
    </message>
    <message>
        <source>dark violet</source>
        <translation>深紫色</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>紫色</translation>
    </message>
    <message>
        <source>light violet</source>
        <translation>浅紫色</translation>
    </message>
    <message>
        <source>dark magenta</source>
        <translation>深洋红色</translation>
    </message>
    <message>
        <source>magenta</source>
        <translation>洋红色</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>粉红色</translation>
    </message>
    <message>
        <source>black</source>
        <translation>黑色</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>深灰色</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>灰色</translation>
    </message>
    <message>
        <source>light grey</source>
        <translation>浅灰色</translation>
    </message>
    <message>
        <source>white</source>
        <translation>白色</translation>
    </message>
</context>
<context>
    <name>SpokenNames</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>More buttons</source>
        <translation>更多按钮</translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message>
        <source>stroke %1</source>
        <translation>笔画 %1</translation>
    </message>
    <message>
        <source>even</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>feathered</source>
        <translation>羽化</translation>
    </message>
    <message>
        <source>dark edge</source>
        <translation>深色边缘</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>%1 and other colours</source>
        <translation>%1等多种颜色</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>有填充</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 条线段</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln 条笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>已选择 %Ln 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Selects this and nothing else</source>
        <translation>仅选择此项</translation>
    </message>
    <message>
        <source>Adds this to the selection, or takes it away</source>
        <translation>将此项加入选择或移出选择</translation>
    </message>
</context>
<context>
    <name>suffuse::PenSpeech</name>
    <message>
        <source>Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.</source>
        <translation>方向键移动画笔，空格键落笔和抬笔。Esc 收起画笔。</translation>
    </message>
    <message>
        <source>The pen is put away.</source>
        <translation>画笔已收起。</translation>
    </message>
    <message>
        <source>Pen down at %1.</source>
        <translation>在 %1 处落笔。</translation>
    </message>
    <message>
        <source>Pen up at %1.</source>
        <translation>在 %1 处抬笔。</translation>
    </message>
    <message>
        <source>Pen up at %1: %2.</source>
        <translation>在 %1 处抬笔：%2。</translation>
    </message>
    <message>
        <source>Given up.</source>
        <translation>已放弃。</translation>
    </message>
    <message>
        <source>Pressure %1 %</source>
        <translation>压力 %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>suffuse::Samples</name>
    <message>
        <source>Harbour</source>
        <translation>海港</translation>
    </message>
    <message>
        <source>Ink Landscape</source>
        <translation>水墨山水</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <translation>灯笼</translation>
    </message>
    <message>
        <source>Moonrise</source>
        <translation>月出</translation>
    </message>
    <message>
        <source>Sheet of Strokes</source>
        <translation>笔画样张</translation>
    </message>
    <message>
        <source>Still Life</source>
        <translation>静物</translation>
    </message>
</context>
</TS>
