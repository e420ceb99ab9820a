<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>the principal point is far from the centre of the picture, which seems cut out of a larger one</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>主点远离图片中心，图片似乎是从更大的图片裁剪而来</translation>
  </message>
  <message>
   <source>with aspect ratio and principal point {px} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>加入像素宽高比和主点后为 {px} px：没有明显改善</translation>
  </message>
  <message>
   <source>coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>坐标看起来像像素，应为 0 到 1（x = {x:g}，y = {y:g}）</translation>
  </message>
  <message>
   <source>without lens distortion the points are {without} px off, with it {with_it} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>不含镜头畸变时点偏离 {without} px，含畸变时 {with_it} px：没有明显改善</translation>
  </message>
  <message>
   <source>aspect ratio and principal point bring the points from {before} to {after} px, more than three parameters would by chance</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>像素宽高比和主点使点从 {before} 降到 {after} px，超过三个参数偶然所能达到的</translation>
  </message>
  <message>
   <source>lens distortion brings the points from {before} to {after} px</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>镜头畸变使点从 {before} 降到 {after} px</translation>
  </message>
  <message>
   <source>the points show lens distortion clearly and are {px} px off</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>点明显显示镜头畸变，偏离 {px} px</translation>
  </message>
  <message>
   <source>even with the position known: {why}</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>即使位置已知：{why}</translation>
  </message>
  <message>
   <source>{count} positions, and nothing tells which is its</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>有 {count} 个位置，无法判断哪个属于它</translation>
  </message>
  <message>
   <source>all labels fit with far and near exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>远近互换后所有类别都吻合</translation>
  </message>
  <message>
   <source>all labels fit with left and right exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>左右互换后所有类别都吻合</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, {before:.1f} px as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>元素平均偏离 {after:.1f} px，按现状为 {before:.1f} px</translation>
  </message>
  <message>
   <source>two points are exchanged: the one of {some} and the one of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>两个点互换了：{some} 的点与 {others} 的点</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, no camera fits the labels as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>元素平均偏离 {after:.1f} px，按现有类别没有吻合的相机</translation>
  </message>
  <message>
   <source>{a} and {b} fit with each other's label</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} 和 {b} 互换类别后吻合</translation>
  </message>
  <message>
   <source>{titles} fit with each other's labels</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} 互换类别后吻合</translation>
  </message>
  <message>
   <source>relabel {steps}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>更改类别：{steps}</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} 与其他元素所得相机的位置最多相差 {px:.0f} px</translation>
  </message>
  <message>
   <source>{title} is nowhere near where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} 远离其他元素所得相机显示的位置</translation>
  </message>
  <message>
   <source>without {titles} the others drop from {before:.1f} to {after:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>去掉 {titles} 后，其余从 {before:.1f} 降到 {after:.1f} px</translation>
  </message>
  <message>
   <source>swap {a} and {b}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>互换 {a} 和 {b}</translation>
  </message>
  <message>
   <source>{a} to {b}</source>
   <comment>labels</comment>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} 改为 {b}</translation>
  </message>
  <message>
   <source>it lies where {title} should be</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>它位于 {title} 应在之处</translation>
  </message>
  <message>
   <source>the others are {px:.1f} px off with and without it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>有无它，其余都偏离 {px:.1f} px</translation>
  </message>
  <message>
   <source>more than its own place is uncertain</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>超过其自身位置的不确定度</translation>
  </message>
  <message>
   <source>relabel to {title}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>类别改为 {title}</translation>
  </message>
  <message>
   <source>it lies on {title}, which is annotated as well</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>它位于 {title} 上，后者也已标注</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera shows it; too few elements fit to say which are wrong</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} 与相机显示的位置最多相差 {px:.0f} px；吻合的元素太少，无法判断哪些有误</translation>
  </message>
  <message>
   <source>no camera fits these labels together</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>没有相机同时吻合这些类别</translation>
  </message>
  <message>
   <source>exchange far and near in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>整帧互换远近</translation>
  </message>
  <message>
   <source>exchange left and right in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>整帧互换左右</translation>
  </message>
  <message>
   <source>turn the labels by half a turn</source>
   <extracomment>[procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>将类别旋转半圈</translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn</source>
   <extracomment>the camera stands on a side of the field where hardly any other of {n} frame does: a camera of its own, or labels turned by half a turn / the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>相机位于场地的一侧，而 {n} 帧中几乎没有其他帧在该侧：可能是另一台相机，或类别旋转了半圈</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does</source>
   <extracomment>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frame does / the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>相机与其余的帧分处场地两侧；将类别旋转半圈后，它与 {n} 帧的相机位置一致</numerusform>
   </translation>
  </message>
  <message>
   <source>no such class: {name!r}, did you mean {title}?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>没有此类别：{name!r}，是否指 {title}？</translation>
  </message>
  <message>
   <source>{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more than any lens bends it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} 在场地上是直的，但其点偏离直线最多 {px:.0f} px，超出任何镜头的弯曲</translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points, a line takes two</source>
   <extracomment>{title} has {n} point, a line takes two / {title} has {n} points, a line takes two [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} 有 {n} 个点，一条线需要两个</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points; a curve takes at least {least}</source>
   <extracomment>{title} has {n} point; a curve takes at least {least} / {title} has {n} points; a curve takes at least {least} [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} 有 {n} 个点；曲线至少需要 {least} 个</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points: {least} points needed for a curve</source>
   <extracomment>{title} has {n} point: {least} points needed for a curve / {title} has {n} points: {least} points needed for a curve [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} 有 {n} 个点：曲线需要 {least} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>{title} is a single place, it has {count} points up to {px:.0f} px apart</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} 是单个位置，却有 {count} 个点，相距最多 {px:.0f} px</translation>
  </message>
  <message>
   <source>the points of {title} go back and forth instead of along it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} 的点来回往返，而非沿其排列</translation>
  </message>
  <message>
   <source>no such class: {name!r} fits no camera, and counts as missed where it is scored</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>没有此类别：{name!r} 不吻合任何相机，评分时计为未命中</translation>
  </message>
  <message>
   <source>{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two names?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{a} 和 {b} 重叠，相距不到 {px:.0f} px：同一条线用了两个名称？</translation>
  </message>
  <message>
   <source>remove point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>移除第 {number} 点</translation>
  </message>
  <message>
   <source>look at point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>查看第 {number} 点</translation>
  </message>
  <message>
   <source>the points of {title} go over the same stretch more than once: their course is {times:.1f} times as long as it need be</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} 的点多次经过同一区段：其路径长度是所需的 {times:.1f} 倍</translation>
  </message>
  <message>
   <source>That is annotated already</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>该类别已标注</translation>
  </message>
  <message>
   <source>its corner</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>其角点</translation>
  </message>
  <message>
   <source>the picture's edge</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>图片边缘</translation>
  </message>
  <message>
   <source>move its points onto the line</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>将其点移到线上</translation>
  </message>
  <message>
   <source>{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} 是弯的：点与点之间线偏离最多 {px:.0f} px。按 R 沿线跟随</translation>
  </message>
  <message>
   <source>one end of {title} is {px:.0f} px off the line. Move it onto the paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} 的一端偏离线 {px:.0f} px。请移到画线上</translation>
  </message>
  <message>
   <source>{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends? Press R</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} 有 {percent:.0f} % 不在画线上（最长间断 {px:.0f} px）。线是弯的？请按 R</translation>
  </message>
  <message>
   <source>one end of {title} is not on paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} 的一端不在画线上</translation>
  </message>
  <message>
   <source>{title} stops {px:.0f} px short of {what}</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} 离{what}还差 {px:.0f} px</translation>
  </message>
  <message>
   <source>look at it</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>查看</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>{title} 的第 {number} 点偏离 {off:.0f} px，其他点最多 {rest:.1f} px</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>{title} 的第 {number} 点偏离 {off:.0f} px，另一点最多 {rest:.1f} px</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>整体方向相反：远近颠倒</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>整体方向相反：左右颠倒</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, or left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>整体方向相反：远近或左右颠倒</translation>
  </message>
  <message>
   <source>{title} is on the wrong side of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{title} 位于 {others} 的错误一侧</translation>
  </message>
  <message>
   <source>{titles} lie on each other's side of the elements around them</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} 相对周围元素互处对方的一侧</translation>
  </message>
  <message>
   <source>{titles} cannot lie this way round to each other, whatever the camera</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} 不可能以这种方向相对，无论何种相机</translation>
  </message>
  <message>
   <source>only {share:.0%} of the lines in sight are on paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py, procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>只有 {share:.0%} 的可见线落在画线上</translation>
  </message>
  <message>
   <source>there is too little paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>画线太少</translation>
  </message>
  <message>
   <source>the paint nearby would take a peg from its place</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>附近的画线会使固定桩偏离原位</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line, and {more} more are off theirs</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} 偏离其线 {px:.0f} px，另有 {more} 个也偏离</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} 偏离其线 {px:.0f} px</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, {needed} needed</source>
   <extracomment>{n} element, {needed} needed / {n} elements, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} 个元素，需要 {needed} 个</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{points} points on {n} elements, two different ones on each of {needed} needed</source>
   <extracomment>{points} points on {n} element, two different ones on each of {needed} needed / {points} points on {n} elements, two different ones on each of {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} 个元素上共 {points} 个点，需要 {needed} 个元素各有两个不同的点</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} elements on the ground, {needed} needed</source>
   <extracomment>{n} element on the ground, {needed} needed / {n} elements on the ground, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} 个地面元素，需要 {needed} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>all points lie in one place of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>所有点都在图片的同一处</translation>
  </message>
  <message>
   <source>all points lie on one line of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>所有点都在图片的一条直线上</translation>
  </message>
  <message>
   <source>not a plausible pose: the fit did not settle</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：拟合未收敛</translation>
  </message>
  <message>
   <source>not a plausible pose: on the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：在地面上</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.1f} m below the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：在地面以下 {metres:.1f} m</translation>
  </message>
  <message>
   <source>not a plausible pose: only {metres:.1f} m above the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：仅高出地面 {metres:.1f} m</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.0f} m from the field's centre</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：距场地中心 {metres:.0f} m</translation>
  </message>
  <message>
   <source>not a plausible pose: rolled by {degrees:.0f} degrees</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：横滚 {degrees:.0f} 度</translation>
  </message>
  <message>
   <source>not a plausible pose: focal length {px:.0f} px at 960 px width</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>位姿不合理：宽 960 px 时焦距为 {px:.0f} px</translation>
  </message>
  <message>
   <source>pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>水平转动、俯仰或横滚 ± 超过 {degrees:g}°，位置 ± 超过到场地中心距离的 {way:g} %，或焦距 ± 超过 {focal:g} %，或从另一端看相同的点击</translation>
  </message>
  <message>
   <source>no camera explains these elements together: the best one misses half of them by more than {px:.0f} px (are the labels right?)</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>没有相机能同时解释这些元素：最好的也有一半偏离超过 {px:.0f} px（类别是否正确？）</translation>
  </message>
  <message>
   <source>pan ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>水平转动 ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>tilt ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>俯仰 ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>roll ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>横滚 ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>position ± {metres:.0f} m</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>位置 ± {metres:.0f} m</translation>
  </message>
  <message>
   <source>focal length ± {percent:.0f} %</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>焦距 ± {percent:.0f} %</translation>
  </message>
  <message>
   <source>the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>从另一端看相同</translation>
  </message>
  <message>
   <source>a different view fits almost as well</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>另一视角几乎同样吻合</translation>
  </message>
  <message>
   <source>expected lines are missing</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>缺少应有的线</translation>
  </message>
  <message>
   <source>some lines in the picture do not match the field</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>图片中有些线与场地不符</translation>
  </message>
  <message>
   <source>too few lines in view</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>可见的线太少</translation>
  </message>
  <message>
   <source>unusual camera position</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>相机位置异常</translation>
  </message>
  <message>
   <source>the visible lines do not determine the camera</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>可见的线不足以确定相机</translation>
  </message>
  <message>
   <source>{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>找到 {lines:.0f} % 的应有线，吻合 {paint:.0f} % 的可见画线</translation>
  </message>
  <message>
   <source>is this {field}? {why}</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>这是 {field} 吗？{why}</translation>
  </message>
  <message>
   <source>no camera fits the lines (best: {shares})</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>没有相机与这些线吻合（最佳：{shares}）</translation>
  </message>
  <message>
   <source>the picture is nearly square: its pixels may not be</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>图片接近正方形：其像素可能不是正方形</translation>
  </message>
  <message>
   <source>{field} has no painted lines to look for</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{field} 没有可寻找的画线</translation>
  </message>
  <message>
   <source>no camera has its lines on the paint of this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>没有相机的线落在此图片的画线上</translation>
  </message>
  <message>
   <source>there is hardly any paint on the ground in this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>此图片的地面上几乎没有画线</translation>
  </message>
  <message>
   <source>too little paint in sight</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>可见画线太少</translation>
  </message>
  <message>
   <source>too little of what should be in sight was found</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>本应可见的内容找到得太少</translation>
  </message>
  <message>
   <source>the paint that was found would move the camera too far</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>找到的画线会使相机移动过多</translation>
  </message>
  <message>
   <source>the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>像素的宽高比可能不是 {aspect:.3f}（{percent:.0f} %）</translation>
  </message>
  <message>
   <source>the track is {px:.0f} px off the nearest frame whose camera was known</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>跟踪结果与最近的已知相机帧相差 {px:.0f} px</translation>
  </message>
  <message>
   <source>{count} of {total} clicks lie where the camera shows nothing</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>{total} 次点击中有 {count} 次位于相机没有显示内容之处</translation>
  </message>
  <message>
   <source>the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least {least:g} are needed)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>各视图几乎从同一方向看它（相差 {degrees:.2f} 度，至少需要 {least:g} 度）</translation>
  </message>
  <message>
   <source>clicked in no view that has a camera</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>未在任何有相机的视图中点击</translation>
  </message>
  <message>
   <source>cameras that know only the ground (homographies) have no position in space</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>只知道地面的相机（单应矩阵）无法给出空间位置</translation>
  </message>
  <message>
   <source>the lines of sight meet behind the camera of {names}</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>视线相交于 {names} 的相机之后</translation>
  </message>
  <message>
   <source>clicked in one view only</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>只在一个视图中点击</translation>
  </message>
  <message>
   <source>would be farther than {metres:g} m from the field</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>会距场地超过 {metres:g} m</translation>
  </message>
  <message>
   <source>the views do not agree: {far} px off (is it the same place in all of them, and are the cameras right?)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>各视图不一致：相差 {far} px（所有视图中是同一位置吗？相机正确吗？）</translation>
  </message>
  <message>
   <source>Fitted to the clicks of each frame; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>根据每帧的点击拟合；均未存为文件</translation>
  </message>
  <message>
   <source>the paint is {px:.1f} px from the lines</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>画线偏离线 {px:.1f} px</translation>
  </message>
  <message>
   <source>Followed through the shot; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>随镜头跟踪；均未存为文件</translation>
  </message>
  <message>
   <source>no track here: {why}</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>此处没有跟踪：{why}</translation>
  </message>
  <message>
   <source>no fit of {frame} yet</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>{frame} 尚无拟合</translation>
  </message>
  <message>
   <source>no camera was found</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py, procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>未找到相机</translation>
  </message>
  <message>
   <source>carried over by the picture's motion, not measured on paint</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>由图片的运动延续而来，未在画线上测量</translation>
  </message>
  <message>
   <source>not followed so far</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>目前未跟踪</translation>
  </message>
  <message>
   <source>{title} was surveyed: its position stays as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} 为实测：其位置保持不变</translation>
  </message>
  <message>
   <source>{title} moves: its positions hold for an instant each</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} 会移动：其位置各只对一个瞬间有效</translation>
  </message>
  <message>
   <source>its camera is hardly determined: {what}</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>其相机难以确定：{what}</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why}), and {count} more</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>{frame} 中没有相机（{why}），另有 {count} 帧</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why})</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>{frame} 中没有相机（{why}）</translation>
  </message>
  <message>
   <source>surveyed: kept as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>实测：保持不变</translation>
  </message>
  <message>
   <source>untouched</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>未动</translation>
  </message>
  <message>
   <source>in progress</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>进行中</translation>
  </message>
  <message>
   <source>done</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>完成</translation>
  </message>
  <message>
   <source>approved</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>已批准</translation>
  </message>
  <message>
   <source>rejected</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>已退回</translation>
  </message>
  <message>
   <source>clicked</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>点击</translation>
  </message>
  <message>
   <source>snapped</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>吸附</translation>
  </message>
  <message>
   <source>regularised</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>规整</translation>
  </message>
  <message>
   <source>copied</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>复制</translation>
  </message>
  <message>
   <source>moved</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>移动</translation>
  </message>
  <message>
   <source>accepted suggestion</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>接受的建议</translation>
  </message>
  <message>
   <source>proposed</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>提议</translation>
  </message>
  <message>
   <source>accepted proposal</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>接受的提议</translation>
  </message>
  <message>
   <source>unconfirmed by paint</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>未得到画线证实</translation>
  </message>
  <message>
   <source>from the file</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>来自文件</translation>
  </message>
  <message>
   <source>camera</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>相机</translation>
  </message>
  <message>
   <source>annotation</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>标注</translation>
  </message>
  <message>
   <source>fine</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>无误</translation>
  </message>
  <message>
   <source>camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>相机错误</translation>
  </message>
  <message>
   <source>labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>标注错误</translation>
  </message>
  <message>
   <source>OK</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>无误</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>已撤回</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>已保存</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/dataset/workspace.py]</extracomment>
   <translation>原始状态</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>在别处保存的内容</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>已覆盖</translation>
  </message>
  <message>
   <source>fitted on these clicks</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>根据这些点击拟合</translation>
  </message>
  <message>
   <source>fitted to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>由这些标注的另一版本拟合</translation>
  </message>
  <message>
   <source>fitted on these clicks, or to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>由这些点击或这些标注的另一版本拟合</translation>
  </message>
  <message>
   <source>closer to these clicks than a prediction can be</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>比任何预测都更接近这些点击</translation>
  </message>
  <message>
   <source>by file type and content</source>
   <extracomment>[procc_annotator/formats/cameras/registry.py]</extracomment>
   <translation>按文件类型和内容</translation>
  </message>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>文件</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>编辑</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>帧</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>元素</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, the menus]</extracomment>
   <translation>视图</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/command_palette.py, the menus]</extracomment>
   <translation>相机</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>帮助</translation>
  </message>
  <message>
   <source>The picture cannot be shown</source>
   <extracomment>[procc_annotator/gui/canvas/annotation_preview.py]</extracomment>
   <translation>图片无法显示</translation>
  </message>
  <message>
   <source>no camera is known here that could be dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>此处没有可拖动的相机</translation>
  </message>
  <message>
   <source>taken back: the camera is as before it was dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>已撤回：相机恢复到拖动之前</translation>
  </message>
  <message>
   <source>overlays are hidden (Ctrl+H)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>叠加层已隐藏（Ctrl+H）</translation>
  </message>
  <message>
   <source>a homography cannot be turned: choose another model (panel Fit)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>单应矩阵无法转动：请选择其他模型（“拟合”面板）</translation>
  </message>
  <message>
   <source>release leaves it here</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>松开即留在此处</translation>
  </message>
  <message>
   <source>Esc puts it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py, procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 放回原处</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs hold the camera</source>
   <extracomment>{n} peg holds the camera / {n} pegs hold the camera [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>{n} 个固定桩约束相机</numerusform>
   </translation>
  </message>
  <message>
   <source>CAMERA</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>相机</translation>
  </message>
  <message numerus="yes">
   <source>peg taken away: {n} pegs left</source>
   <extracomment>peg taken away: {n} peg left / peg taken away: {n} pegs left [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>已移除固定桩：剩余 {n} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>peg taken away: the camera is as it was found</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>已移除固定桩：相机恢复为求得的状态</translation>
  </message>
  <message>
   <source>peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>固定桩</translation>
  </message>
  <message>
   <source>press on a line of the wireframe</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>按住线框上的一条线</translation>
  </message>
  <message>
   <source>drag moves this peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>拖动可移动此固定桩</translation>
  </message>
  <message>
   <source>click takes it away</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>点击可移除</translation>
  </message>
  <message>
   <source>drag a place of the wireframe to where it belongs</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>将线框上的一处拖到其应在的位置</translation>
  </message>
  <message>
   <source>drag {title} to where it belongs: the camera follows</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>将 {title} 拖到其应在的位置：相机随之移动</translation>
  </message>
  <message>
   <source>Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Ctrl+Z 撤回</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py, procc_annotator/gui/settings.py, procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>图片</translation>
  </message>
  <message>
   <source>PAN</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>平移</translation>
  </message>
  <message>
   <source>drag moves the picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>拖动可移动图片</translation>
  </message>
  <message>
   <source>Esc takes the tool again</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Esc 换回工具</translation>
  </message>
  <message>
   <source>load a second set of cameras to blink between two (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>加载第二组相机以在两者间切换查看（Ctrl+L）</translation>
  </message>
  <message>
   <source>crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks, Esc puts it away</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>十字光标：方向键移动（Shift 0.1 px，Ctrl 10 px，Ctrl+Shift 100 px），空格点击，Esc 收起</translation>
  </message>
  <message>
   <source>point at a line first: with the mouse, or with the arrows</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>请先指向一条线：用鼠标或方向键</translation>
  </message>
  <message>
   <source>there is no line here to put a point on</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>此处没有可放置点的线</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>相机无法读取</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>此处无相机</translation>
  </message>
  <message>
   <source>next: {title}</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>下一个：{title}</translation>
  </message>
  <message>
   <source>{title}  ±{sd:.1f} px  unsure</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>{title}  ±{sd:.1f} px  存疑</translation>
  </message>
  <message>
   <source>{title} has no points in this frame: choose the element to delete</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} 在本帧没有点：请选择要删除的元素</translation>
  </message>
  <message>
   <source>choose the element to delete first: field map, list, or its key</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>请先选择要删除的元素：场地图、列表或其按键</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} points of {title}</source>
   <extracomment>dropped {n} point of {title} / dropped {n} points of {title} [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>已丢弃 {title} 的 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>{titles}: changed elsewhere, look again first</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{titles}：已在别处更改，请先再看一遍</translation>
  </message>
  <message numerus="yes">
   <source>kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on</source>
   <extracomment>kept {n} click of {title} on {frame}, unfinished: choose it there to go on / kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>已保留 {frame} 上 {title} 的 {n} 次点击（未完成）：在该帧选择它即可继续</numerusform>
   </translation>
  </message>
  <message>
   <source>finished {title}</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>已完成 {title}</translation>
  </message>
  <message>
   <source>How good the fitted camera is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>拟合相机有多好</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上的米数，1 σ</translation>
  </message>
  <message>
   <source>How good the fitted camera ({model}) is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>拟合相机（{model}）有多好</translation>
  </message>
  <message>
   <source>{metres:g} m, asked of offside technology</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m，越位技术的要求</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd, median {median:.2f}</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上的米数，1 σ，中位数 {median:.2f}</translation>
  </message>
  <message>
   <source>metres on the ground</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上的米数</translation>
  </message>
  <message>
   <source>{metres:g} m: {percent:.0f} % of the field in sight</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m：可见场地的 {percent:.0f} %</translation>
  </message>
  <message>
   <source>Blind: no camera is shown before Ctrl+Enter</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>盲标：按 Ctrl+回车之前不显示相机</translation>
  </message>
  <message>
   <source>Blind mode, this frame is committed</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>盲标模式，本帧已提交</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs</source>
   <extracomment>{n} peg / {n} pegs [procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>
    <numerusform>{n} 个固定桩</numerusform>
   </translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>已拖动相机，{pegs}，已按画线精化：其线的 {share:.0%}</translation>
  </message>
  <message>
   <source>Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>找到相机，存疑：{why}。Shift+Enter 接受，Delete 拒绝</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, not made exact: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>已拖动相机，{pegs}，未精化：{why}</translation>
  </message>
  <message>
   <source>Drag to move the divider (arrow keys do it too)</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>拖动以移动分隔线（方向键亦可）</translation>
  </message>
  <message>
   <source>Divider of the split view</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>分割视图的分隔线</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>已拖动相机，{pegs}</translation>
  </message>
  <message>
   <source>Camera of the track: Shift+Enter accepts its elements</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>跟踪所得的相机：Shift+回车接受其元素</translation>
  </message>
  <message>
   <source>Looking for the camera in the picture …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>正在图片中寻找相机 …</translation>
  </message>
  <message>
   <source>No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport? Click here</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>未找到相机：{why}。请先{advice}（Enter 选第一个）。其他运动？点击此处</translation>
  </message>
  <message>
   <source>Camera found, sure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>找到相机，确定：{why}</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}: its lines are looked for …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>已拖动相机，{pegs}：正在寻找其线 …</translation>
  </message>
  <message>
   <source>Camera of the track, unsure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>跟踪所得的相机，存疑：{why}</translation>
  </message>
  <message>
   <source>nothing changed: regular already, or no painted line was found there</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>没有变化：已经规整，或该处未找到画线</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, along the track; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已从 {frame} 复制 {what}，沿跟踪结果；Shift+V 全部确认</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, moved with the camera; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已从 {frame} 复制 {what}，随相机移动；Shift+V 全部确认</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, as they were: no motion found; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已从 {frame} 原样复制 {what}：未找到运动；Shift+V 全部确认</translation>
  </message>
  <message>
   <source>taken back: nothing is regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已撤回：不规整任何内容</translation>
  </message>
  <message>
   <source>taken back: nothing is copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已撤回：不复制任何内容</translation>
  </message>
  <message>
   <source>the frame was left: nothing was regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已离开该帧：未规整任何内容</translation>
  </message>
  <message>
   <source>the frame was left: nothing was copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已离开该帧：未复制任何内容</translation>
  </message>
  <message numerus="yes">
   <source>{n} points unconfirmed by paint</source>
   <extracomment>{n} point unconfirmed by paint / {n} points unconfirmed by paint [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{n} 个点未得到画线证实</numerusform>
   </translation>
  </message>
  <message>
   <source>regularise {what}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>规整 {what}</translation>
  </message>
  <message>
   <source>copy from {frame}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>从 {frame} 复制</translation>
  </message>
  <message>
   <source>left out, not in the picture or no line seen: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>已略过（不在图片中或看不到线）：{elements}</translation>
  </message>
  <message>
   <source>choose an annotated element first</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>请先选择已标注的元素</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements</source>
   <extracomment>{n} element / {n} elements [procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>
    <numerusform>{n} 个元素</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>regularised {what}: {n} points</source>
   <extracomment>regularised {what}: {n} point / regularised {what}: {n} points [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>已规整 {what}：{n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} has corners or is one place: it stays as it is</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{element} 有拐角或只是单个位置：保持不变</translation>
  </message>
  <message>
   <source>no element of the field is annotated here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>此处没有标注场地的元素</translation>
  </message>
  <message>
   <source>no frame before this one is annotated</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>本帧之前没有已标注的帧</translation>
  </message>
  <message>
   <source>{frame} has no element that is missing here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} 没有此处缺少的元素</translation>
  </message>
  <message>
   <source>{element} becomes {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 变为 {other}</translation>
  </message>
  <message>
   <source>duplicate {element} as {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>将 {element} 复制为 {other}</translation>
  </message>
  <message>
   <source>merge {element} into {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>将 {element} 并入 {other}</translation>
  </message>
  <message>
   <source>close gaps</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>闭合间隙</translation>
  </message>
  <message numerus="yes">
   <source>confirm {n} elements</source>
   <extracomment>confirm {n} element / confirm {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>确认 {n} 个元素</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>drop {n} unconfirmed elements</source>
   <extracomment>drop {n} unconfirmed element / drop {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>丢弃 {n} 个未确认的元素</numerusform>
   </translation>
  </message>
  <message>
   <source>Name of the line</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>线的名称</translation>
  </message>
  <message>
   <source>What is this line?</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>这是哪条线？</translation>
  </message>
  <message>
   <source>{element} is a curve, which two points do not show: click on</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 是曲线，两个点无法表示：请继续点击</translation>
  </message>
  <message>
   <source>swap {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>互换 {element} 和 {other}</translation>
  </message>
  <message>
   <source>{element} is its own symmetric element</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 的对称类别就是它自己</translation>
  </message>
  <message numerus="yes">
   <source>{elements} are annotated already</source>
   <extracomment>{elements} is annotated already / {elements} are annotated already [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{elements} 已标注</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} lies where {other} is: drag it to its place</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 位于 {other} 处：请将其拖到位</translation>
  </message>
  <message>
   <source>reverse {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>反转 {element}</translation>
  </message>
  <message>
   <source>choose the point to split at first (edit mode)</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>请先选择分割处的点（编辑模式）</translation>
  </message>
  <message>
   <source>split {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>分割 {element}</translation>
  </message>
  <message numerus="yes">
   <source>confirmed {n} elements</source>
   <extracomment>confirmed {n} element / confirmed {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>已确认 {n} 个元素</numerusform>
   </translation>
  </message>
  <message>
   <source>nothing is unconfirmed on this frame</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>本帧没有未确认的内容</translation>
  </message>
  <message>
   <source>{element} is annotated already</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 已经标注</translation>
  </message>
  <message>
   <source>no end is that near to a corner or the picture's edge</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>没有端点那么靠近角点或图片边缘</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} unconfirmed elements</source>
   <extracomment>dropped {n} unconfirmed element / dropped {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>已丢弃 {n} 个未确认的元素</numerusform>
   </translation>
  </message>
  <message>
   <source>Another element…</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>其他元素…</translation>
  </message>
  <message>
   <source>Leave it unnamed</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>不命名</translation>
  </message>
  <message>
   <source>an element is split at a point between its ends, into a class that is free</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>元素须在两端之间的点处分割，分成一个空闲的类别</translation>
  </message>
  <message>
   <source>{element} was changed elsewhere: look at it again</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} 已在别处更改：请再看一遍</translation>
  </message>
  <message>
   <source>? (stays as it is, an unknown class)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>?（保持不变，未知类别）</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>排除</translation>
  </message>
  <message>
   <source>Label</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>标签</translation>
  </message>
  <message>
   <source>Shapes</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>形状</translation>
  </message>
  <message>
   <source>Stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>代表</translation>
  </message>
  <message>
   <source>Why</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>原因</translation>
  </message>
  <message>
   <source>sure</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>确定</translation>
  </message>
  <message>
   <source>likely</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>可能</translation>
  </message>
  <message>
   <source>to be said</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>待指定</translation>
  </message>
  <message numerus="yes">
   <source>{n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on.</source>
   <extracomment>{n} label is no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. / {n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. [procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>
    <numerusform>{n} 个标签不是{field}的类别。请指明其含义；建议由其用词和形状所在的元素得出。</numerusform>
   </translation>
  </message>
  <message>
   <source>These names are more like those of {field}: choose that field first (File &gt; Field).</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>这些名称更像{field}的名称：请先选择该场地（文件 &gt; 场地）。</translation>
  </message>
  <message>
   <source>Names of another program</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>其他程序的名称</translation>
  </message>
  <message>
   <source>Keep these names with the dataset ({file})</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>将这些名称保存在数据集中（{file}）</translation>
  </message>
  <message>
   <source>Import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>导入</translation>
  </message>
  <message>
   <source>What {label} stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>{label} 代表什么</translation>
  </message>
  <message>
   <source>What came of it</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>结果如何</translation>
  </message>
  <message>
   <source>Import annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>导入标注</translation>
  </message>
  <message>
   <source>Annotations to import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>要导入的标注</translation>
  </message>
  <message>
   <source>Look into the files</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>查看文件内容</translation>
  </message>
  <message>
   <source>Only frames without annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>仅限尚未标注的帧</translation>
  </message>
  <message>
   <source>Replace what is annotated in the others, too</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>也替换其他帧中的标注</translation>
  </message>
  <message>
   <source>What was there stays among the earlier versions of its frame, and undo brings it back</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>原有内容保留在该帧的早期版本中，撤销可恢复</translation>
  </message>
  <message>
   <source>Annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>标注</translation>
  </message>
  <message>
   <source>Format</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>格式</translation>
  </message>
  <message>
   <source>Import into</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>导入到</translation>
  </message>
  <message>
   <source>Annotations (*.json *.xml *.zip);;All files (*)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>标注 (*.json *.xml *.zip);;所有文件 (*)</translation>
  </message>
  <message>
   <source>Export as</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>导出为</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>导出…</translation>
  </message>
  <message>
   <source>One zip archive instead of a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>一个 zip 压缩包而非文件夹</translation>
  </message>
  <message>
   <source>Replace files that are there</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>替换已有文件</translation>
  </message>
  <message>
   <source>Keep elements that SoccerNet has no class for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>保留 SoccerNet 没有类别的元素</translation>
  </message>
  <message>
   <source>Width of the lines</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>线宽</translation>
  </message>
  <message>
   <source>Copy the pictures as well</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>同时复制图片</translation>
  </message>
  <message>
   <source>Export to a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>导出到文件夹</translation>
  </message>
  <message>
   <source>Keeps {holds}.
Loses {loses}.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>保留{holds}。
丢失{loses}。</translation>
  </message>
  <message>
   <source>Add these names to the dataset's {file}, written anew</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>将这些名称加入数据集的 {file}（重新写出）</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/messages.py]</extracomment>
   <translation>取消</translation>
  </message>
  <message>
   <source>Close</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>关闭</translation>
  </message>
  <message>
   <source>A folder, a zip archive, or one file</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>文件夹、zip 压缩包或单个文件</translation>
  </message>
  <message>
   <source>File…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>文件…</translation>
  </message>
  <message>
   <source>Folder…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>文件夹…</translation>
  </message>
  <message>
   <source>Frames are matched by the name of their picture.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>按图片名称匹配帧。</translation>
  </message>
  <message>
   <source>Zip archive (*.zip)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Zip 压缩包 (*.zip)</translation>
  </message>
  <message>
   <source>{frames}, {elements} and {points} written to {path} ({format}).</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>已将{frames}、{elements}和{points}写入 {path}（{format}）。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} annotations</source>
   <extracomment>{n:,} annotation / {n:,} annotations [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个标注</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>JaC of {n:,} frames</source>
   <extracomment>JaC of {n:,} frame / JaC of {n:,} frames [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧的 JaC</numerusform>
   </translation>
  </message>
  <message>
   <source>Not everything could be saved: what is on disk goes.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>未能全部保存：以磁盘上的内容为准。</translation>
  </message>
  <message>
   <source>Nothing was written: no frame is annotated, or none could be written.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>未写出任何内容：没有已标注的帧，或均无法写出。</translation>
  </message>
  <message>
   <source>the fit of {frame} is saved as {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame} 的拟合已保存为 {path}</translation>
  </message>
  <message>
   <source>{source} is made from the clicks it would be scored against: judge the cameras to be scored (procc-annotator calibrate fits and scores a set)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{source} 由将用于评分的点击得出：请评判要评分的相机（procc-annotator calibrate 可拟合并评分数据集）</translation>
  </message>
  <message>
   <source>{annotations} and {scores}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{annotations}和{scores}</translation>
  </message>
  <message>
   <source>nothing: no frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>无：没有已标注的帧</translation>
  </message>
  <message>
   <source>export: cancelled; files that were written already are still there</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>导出：已取消；已写出的文件仍在</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames</source>
   <extracomment>{n:,} frame / {n:,} frames [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} elements</source>
   <extracomment>{n:,} element / {n:,} elements [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个元素</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points</source>
   <extracomment>{n:,} point / {n:,} points [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>Zip archive (*.zip);;Folder (*)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Zip 压缩包 (*.zip);;文件夹 (*)</translation>
  </message>
  <message>
   <source>Save copies to</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>副本保存到</translation>
  </message>
  <message numerus="yes">
   <source>copied {n:,} frames to {folder}; they are not saved in their own place yet</source>
   <extracomment>copied {n:,} frame to {folder}; it is not saved in its own place yet / copied {n:,} frames to {folder}; they are not saved in their own place yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>已将 {n:,} 帧复制到 {folder}；尚未保存到原位置</numerusform>
   </translation>
  </message>
  <message>
   <source>Table (*.csv);;JSON (*.json)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>表格 (*.csv);;JSON (*.json)</translation>
  </message>
  <message>
   <source>Table (*.csv)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>表格 (*.csv)</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} frames to {path}</source>
   <extracomment>exported {n:,} frame to {path} / exported {n:,} frames to {path} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>已将 {n:,} 帧导出到 {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the set was being scored still: some frames have no JaC yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>数据集仍在评分：部分帧尚无 JaC</translation>
  </message>
  <message>
   <source>no camera to save: the fit is not there yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>没有可保存的相机：拟合尚未就绪</translation>
  </message>
  <message>
   <source>blind: no frame is committed yet, so there is no JaC to show</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>盲标：尚未提交任何帧，因此没有可显示的 JaC</translation>
  </message>
  <message>
   <source>exported {what} to {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>已将{what}导出到 {path}</translation>
  </message>
  <message>
   <source>Cancelled; files that were written already are still there.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>已取消；已写出的文件仍在。</translation>
  </message>
  <message>
   <source>Not written</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>未写出</translation>
  </message>
  <message>
   <source>What the format cannot hold</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>该格式无法容纳的内容</translation>
  </message>
  <message>
   <source>everything is saved in its own place</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>全部已保存到原位置</translation>
  </message>
  <message>
   <source>no camera to save: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>没有可保存的相机：{why}</translation>
  </message>
  <message>
   <source>the fit is worked out again: save it in a moment</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>正在重新计算拟合：请稍后保存</translation>
  </message>
  <message>
   <source>{frame}: the picture cannot be read, so that the camera's pixels belong to no size; not saved</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame}：图片无法读取，因此相机的像素没有对应的尺寸；未保存</translation>
  </message>
  <message>
   <source>saved as {path}, but the loaded cameras could not be read again: {problem}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>已保存为 {path}，但已加载的相机无法重新读取：{problem}</translation>
  </message>
  <message>
   <source>{saved}; it is hardly determined: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{saved}；它难以确定：{why}</translation>
  </message>
  <message>
   <source>not everything could be saved: the export has the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>未能全部保存：导出的是最近保存的状态</translation>
  </message>
  <message numerus="yes">
   <source>blind mode leaves out {n:,} frames not committed yet</source>
   <extracomment>blind mode leaves out {n:,} frame not committed yet / blind mode leaves out {n:,} frames not committed yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>盲标模式排除 {n:,} 个尚未提交的帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} files could not be read: {problem}</source>
   <extracomment>{n:,} file could not be read: {problem} / {n:,} files could not be read: {problem} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个文件无法读取：{problem}</numerusform>
   </translation>
  </message>
  <message>
   <source>Export</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>导出</translation>
  </message>
  <message>
   <source>exporting {done} / {total}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>正在导出 {done} / {total}</translation>
  </message>
  <message>
   <source>Keep the field, and say nothing more of these classes</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>保留场地，不再提及这些类别</translation>
  </message>
  <message>
   <source>The dataset remembers it, and is not asked about again</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>数据集会记住，不再询问</translation>
  </message>
  <message>
   <source>No, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>否，{field}</translation>
  </message>
  <message>
   <source>The field of this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>此数据集的场地</translation>
  </message>
  <message>
   <source>Descriptions of fields (*.toml)</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>场地描述 (*.toml)</translation>
  </message>
  <message>
   <source>Is this {field}? The classes annotated here are those of {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>这是{field}吗？此处标注的类别属于{field}</translation>
  </message>
  <message>
   <source>{why}, but {file} in the dataset's folder decides</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{why}，但以数据集文件夹中的 {file} 为准</translation>
  </message>
  <message>
   <source>Yes, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>是，{field}</translation>
  </message>
  <message>
   <source>Switch to {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>切换到{field}</translation>
  </message>
  <message>
   <source>{problem}; the field stays as it was: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{problem}；场地保持不变：{field}</translation>
  </message>
  <message>
   <source>Scores then differ from those of the nominal field ({nominal}), as official evaluations take it; they name the dimensions they were computed with.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>这样得分会不同于官方评测所用的标称场地（{nominal}）；得分会注明计算所用的尺寸。</translation>
  </message>
  <message>
   <source>Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is for all others, and for what stadiums leave open.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>各自的尺寸（stadiums.csv）：{stadiums}的{frames}。此处输入的值用于其他所有帧，以及体育场未指定的部分。</translation>
  </message>
  <message>
   <source>Scores then differ from those of official evaluations, which take lines where the rules measure them; they say so.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>这样得分会不同于按规则测量处取线的官方评测；得分会注明。</translation>
  </message>
  <message>
   <source>Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the paint's width away: choose it where that matters, as in halls and near the camera.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>规则中许多线以画线的边缘为准。而点击在画线中间，相差半个线宽：在重要之处请选择它，如室内场馆和靠近相机时。</translation>
  </message>
  <message>
   <source>Only length and width are found from frames, and the rules fix those of this field</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>由帧只能求出长和宽，而规则已固定此场地的长和宽</translation>
  </message>
  <message numerus="yes">
   <source>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.</source>
   <extracomment>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame. / {dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{dimension}：{value:.2f} ± {sd:.2f} m，由 {n} 帧得出。</numerusform>
   </translation>
  </message>
  <message>
   <source>where the rules measure</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>按规则测量处</translation>
  </message>
  <message>
   <source>the middle of the paint</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>画线的中间</translation>
  </message>
  <message>
   <source>Field dimensions: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>场地尺寸：{field}</translation>
  </message>
  <message numerus="yes">
   <source>From the cameras of {n} frames; ± is one standard deviation.</source>
   <extracomment>From the cameras of {n} frame; ± is one standard deviation. / From the cameras of {n} frames; ± is one standard deviation. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>由 {n} 帧的相机得出；± 为一个标准差。</numerusform>
   </translation>
  </message>
  <message>
   <source>{remark}; it stays as it was.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>{remark}；保持不变。</translation>
  </message>
  <message>
   <source>Estimate from this set</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>由此数据集估计</translation>
  </message>
  <message>
   <source>Clicks lie on:</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>点击位于：</translation>
  </message>
  <message>
   <source>Keep for this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>为此数据集保留</translation>
  </message>
  <message>
   <source>Nominal</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>标称</translation>
  </message>
  <message>
   <source>The field as official evaluations take it</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>官方评测所用的场地</translation>
  </message>
  <message>
   <source>nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>标称 {nominal:g} m，规则允许 {minimum:g} 至 {maximum:g} m</translation>
  </message>
  <message>
   <source>&lt;b&gt;not {number:g} m: the rules allow {minimum:g} to {maximum:g} m&lt;/b&gt;</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>&lt;b&gt;不可为 {number:g} m：规则允许 {minimum:g} 至 {maximum:g} m&lt;/b&gt;</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames</source>
   <extracomment>{n} frame / {n} frames [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} 帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} stadiums</source>
   <extracomment>{n} stadium / {n} stadiums [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} 个体育场</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: frames that are not committed took no part ({n}).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>盲标：未提交的帧没有参与（{n}）。</translation>
  </message>
  <message>
   <source>Frames that cannot be read took no part: {n}.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>无法读取的帧没有参与：{n}。</translation>
  </message>
  <message>
   <source>Stop</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py, procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>停止</translation>
  </message>
  <message>
   <source>the rules fix every dimension of the field {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>规则固定了场地{field}的所有尺寸</translation>
  </message>
  <message>
   <source>Blind: the set is checked once one of its frames is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>盲标：提交数据集的一帧后才会查看（Ctrl+回车）。</translation>
  </message>
  <message>
   <source>no further frame this way: {what}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>此方向没有更多的帧：{what}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: JaC {value:.3f}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>第 {place} / {total}，最差在前：JaC {value:.3f}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: largest error {value:.1f} px</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>第 {place} / {total}，最差在前：最大误差 {value:.1f} px</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: median disagreement {value:.2f} m</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>第 {place} / {total}，最差在前：分歧中位数 {value:.2f} m</translation>
  </message>
  <message>
   <source>{place} of {total}, the least sure first</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>第 {place} / {total}，最不确定的在前</translation>
  </message>
  <message>
   <source>none is annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有已标注的</translation>
  </message>
  <message>
   <source>all are annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>全部已标注</translation>
  </message>
  <message>
   <source>all are done or approved</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>全部已完成或批准</translation>
  </message>
  <message>
   <source>none is rejected</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有被退回的</translation>
  </message>
  <message>
   <source>this is the last one</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>这是最后一个</translation>
  </message>
  <message>
   <source>no frame with a score to go to</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有可前往的已评分帧</translation>
  </message>
  <message>
   <source>no frame with a score to go to: blind mode shows those of committed frames only</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有可前往的已评分帧：盲标模式只显示已提交的帧</translation>
  </message>
  <message>
   <source>comparing {source} with {other} over the set</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>正在数据集上比较 {source} 与 {other}</translation>
  </message>
  <message>
   <source>blind mode: how the track does is hidden</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>盲标模式：隐藏跟踪的好坏</translation>
  </message>
  <message>
   <source>no shot was followed yet (T)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>尚未跟踪任何镜头（T）</translation>
  </message>
  <message>
   <source>no other frame is unsure</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有其他存疑的帧</translation>
  </message>
  <message>
   <source>these frames do not follow one another</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>这些帧并不连续</translation>
  </message>
  <message>
   <source>two sources are needed to see where they disagree: load more cameras (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>需要两个源才能看出分歧：请加载更多相机（Ctrl+L）</translation>
  </message>
  <message>
   <source>{source} and {other} cannot be compared on the ground in any frame</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} 和 {other} 在任何帧中都无法在地面上比较</translation>
  </message>
  <message>
   <source>stopped comparing the sources</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>已停止比较各源</translation>
  </message>
  <message>
   <source>this is the worst; once more goes on</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>这是最差的；再按一次继续</translation>
  </message>
  <message>
   <source>no other frame has a score</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有其他已评分的帧</translation>
  </message>
  <message>
   <source>from the worst again</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>重新从最差的开始</translation>
  </message>
  <message>
   <source>two sources are being compared already</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>已有两个源正在比较</translation>
  </message>
  <message>
   <source>{source} and {other} are compared</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} 和 {other} 已比较</translation>
  </message>
  <message>
   <source>none is doubtful</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>没有存疑的</translation>
  </message>
  <message>
   <source>skipped (under {least:.0%} visible): {ghosts}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>已略过（可见不足 {least:.0%}）：{ghosts}</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/commands/ghost_accepting.py, procc_annotator/gui/commands/versions.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>
    <numerusform>{n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>{accepted}: {points}, line seen along {share:.0%}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{accepted}：{points}，{share:.0%} 的线可见</translation>
  </message>
  <message numerus="yes">
   <source>{n} ends of {elements} cannot be seen: the points stop before</source>
   <extracomment>{n} end of {elements} cannot be seen: the points stop before / {n} ends of {elements} cannot be seen: the points stop before [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{elements} 有 {n} 个端点不可见：点在此之前结束</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera is another one meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>相机此时已不同</translation>
  </message>
  <message>
   <source>accept {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>接受 {what}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts</source>
   <extracomment>{n} ghost / {n} ghosts [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} 个虚影</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ghosts</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{total} 个虚影中的 {n} 个</translation>
  </message>
  <message>
   <source>accepted {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>已接受 {what}</translation>
  </message>
  <message>
   <source>the frame was edited meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>该帧此时已被编辑</translation>
  </message>
  <message>
   <source>looking for the line on {frame} took too long</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>在 {frame} 上寻找线用时过长</translation>
  </message>
  <message>
   <source>{element} is not accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受 {element}：{why}</translation>
  </message>
  <message>
   <source>{element}: no painted line is found along it; click it by hand, or say that it is not visible here (.)</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element}：沿线未找到画线；请手动点击，或标明此处不可见（.）</translation>
  </message>
  <message>
   <source>the camera is being fitted: accept its ghosts in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>正在拟合相机：请稍后接受其虚影</translation>
  </message>
  <message>
   <source>no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes through them</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受任何虚影，可见的线不足 {least:.0%}：{ghosts}；Tab 可逐个查看</translation>
  </message>
  <message>
   <source>accepted {what} on {frame}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>已在 {frame} 上接受 {what}</translation>
  </message>
  <message>
   <source>no ghost was accepted: there is no picture to look for their lines in</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受任何虚影：没有图片可寻找其线</translation>
  </message>
  <message>
   <source>no ghost was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受任何虚影：{why}</translation>
  </message>
  <message>
   <source>{element} is not accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受 {element}</translation>
  </message>
  <message>
   <source>the ghost is accepted: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>虚影已接受：请接受新拟合的虚影</translation>
  </message>
  <message>
   <source>what was being drawn is finished: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>正在绘制的内容已完成：请接受新拟合的虚影</translation>
  </message>
  <message>
   <source>no ghost was accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>未接受任何虚影</translation>
  </message>
  <message>
   <source>{element} is accepted once its points are found</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>找到其点后即接受 {element}</translation>
  </message>
  <message>
   <source>go to a ghost (Tab) or choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>请先转到虚影（Tab）或选择元素</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts left, Tab begins again</source>
   <extracomment>{n} ghost left, Tab begins again / {n} ghosts left, Tab begins again [procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>
    <numerusform>剩余 {n} 个，按 Tab 重新开始</numerusform>
   </translation>
  </message>
  <message>
   <source>that was the last ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>那是最后一个虚影</translation>
  </message>
  <message>
   <source>that was the first ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>那是第一个虚影</translation>
  </message>
  <message>
   <source>the camera is being fitted: ghosts come in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>正在拟合相机：虚影马上就来</translation>
  </message>
  <message>
   <source>no ghosts: the camera is looked for in the picture</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：正在图片中寻找相机</translation>
  </message>
  <message>
   <source>no ghosts: no camera is known; {advice}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：相机未知；请{advice}</translation>
  </message>
  <message>
   <source>no ghosts: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：{why}</translation>
  </message>
  <message>
   <source>no ghosts: what else is in sight is annotated, or not known well enough</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：其余可见内容已标注，或还不够确定</translation>
  </message>
  <message>
   <source>no ghosts: they are switched off (Element &gt; Ghosts &gt; Show ghosts)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：已关闭（元素 &gt; 虚影 &gt; 显示虚影）</translation>
  </message>
  <message>
   <source>overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>叠加层已隐藏：看不到虚影（Ctrl+H，或松开 X）</translation>
  </message>
  <message>
   <source>finish what is being drawn first (Enter), or cancel it (Esc)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>请先完成正在绘制的内容（回车），或取消（Esc）</translation>
  </message>
  <message>
   <source>no ghosts: no camera could be fitted</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>没有虚影：无法拟合相机</translation>
  </message>
  <message>
   <source>no camera fits yet</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>尚无合适的相机</translation>
  </message>
  <message>
   <source>it is being drawn by hand</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>正在手动绘制</translation>
  </message>
  <message>
   <source>{title} is annotated here: delete it first (Ctrl+Delete)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} 在此已标注：请先删除（Ctrl+Delete）</translation>
  </message>
  <message>
   <source>{title} is not visible here; Ctrl+. takes it back</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} 在此不可见；Ctrl+. 撤回</translation>
  </message>
  <message>
   <source>{title} may be visible here again</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} 在此可能又可见</translation>
  </message>
  <message>
   <source>no element of this frame was said to be not visible</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>本帧没有被标为不可见的元素</translation>
  </message>
  <message>
   <source>go to a ghost first (Tab)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>请先转到虚影（Tab）</translation>
  </message>
  <message>
   <source>{off}; choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{off}；请先选择元素</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported ({format}).</source>
   <extracomment>{edited} of {n:,} frame imported ({format}). / {edited} of {n:,} frames imported ({format}). [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧中已导入 {edited} 帧（{format}）。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Cancelled: {n:,} frames were not checked.</source>
   <extracomment>Cancelled: {n:,} frame was not checked. / Cancelled: {n:,} frames were not checked. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>已取消：{n:,} 帧未查看。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are annotated already and left unchanged.</source>
   <extracomment>{n:,} frame is annotated already and left unchanged. / {n:,} frames are annotated already and left unchanged. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧已有标注，保持不变。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames hold the same already.</source>
   <extracomment>{n:,} frame holds the same already. / {n:,} frames hold the same already. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧已含相同内容。</numerusform>
   </translation>
  </message>
  <message>
   <source>import</source>
   <comment>a step</comment>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>导入</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported</source>
   <extracomment>{edited} of {n:,} frame imported / {edited} of {n:,} frames imported [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧中已导入 {edited} 帧</numerusform>
   </translation>
  </message>
  <message>
   <source>Cancelled; nothing was imported.</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>已取消；未导入任何内容。</translation>
  </message>
  <message>
   <source>Left as they were</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>保持原样</translation>
  </message>
  <message>
   <source>Could not be read</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>无法读取</translation>
  </message>
  <message>
   <source>Without a picture here ({n})</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>此处没有图片（{n}）</translation>
  </message>
  <message>
   <source>Changed or left out</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>已更改或排除</translation>
  </message>
  <message>
   <source>it could not be saved: {why}</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>无法保存：{why}</translation>
  </message>
  <message>
   <source>error</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>错误</translation>
  </message>
  <message>
   <source>warning</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>警告</translation>
  </message>
  <message>
   <source>hint</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>提示</translation>
  </message>
  <message>
   <source>finding {place} of {total}, {severity}: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>检查结果 {place} / {total}，{severity}：{elements}</translation>
  </message>
  <message>
   <source>no finding is as sure as the Check panel is set to show</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>没有达到“检查”面板所设确定程度的结果</translation>
  </message>
  <message numerus="yes">
   <source>relabelled {n} elements</source>
   <extracomment>relabelled {n} element / relabelled {n} elements [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>已更改 {n} 个元素的类别</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>checked {n:,} frames, camera model {model}: {found}</source>
   <extracomment>checked {n:,} frame, camera model {model}: {found} / checked {n:,} frames, camera model {model}: {found} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>已检查 {n:,} 帧，相机模型 {model}：{found}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} checked frames</source>
   <extracomment>{n:,} checked frame / {n:,} checked frames [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个已检查的帧</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} 和 {other}</translation>
  </message>
  <message>
   <source>the label check is still looking at this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>类别检查仍在检查本帧</translation>
  </message>
  <message>
   <source>the label check has found nothing; check the whole set to look at all frames</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>类别检查未发现问题；检查整个数据集以查看所有帧</translation>
  </message>
  <message>
   <source>{done}; Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{done}；Ctrl+Z 撤回</translation>
  </message>
  <message>
   <source>removed point {n} of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>已移除 {element} 的第 {n} 点</translation>
  </message>
  <message>
   <source>swapped {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>已互换 {element} 和 {other}</translation>
  </message>
  <message>
   <source>relabelled {element} to {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>已将 {element} 改为 {other}</translation>
  </message>
  <message>
   <source>ignored until {elements} changes; the Check panel brings it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>在 {elements} 更改之前忽略；可从“检查”面板恢复</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked</source>
   <extracomment>{n:,} frame cannot be checked / {n:,} frames cannot be checked [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧无法检查</numerusform>
   </translation>
  </message>
  <message>
   <source>Export findings</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>导出检查结果</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} findings in {frames} to {path}</source>
   <extracomment>exported {n:,} finding in {frames} to {path} / exported {n:,} findings in {frames} to {path} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>已将{frames}的 {n:,} 项检查结果导出到 {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the label check has found nothing</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>类别检查未发现问题</translation>
  </message>
  <message>
   <source>the elements have changed since: checked again</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>元素此后已更改：已重新检查</translation>
  </message>
  <message>
   <source>removed point of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>已移除 {element} 的点</translation>
  </message>
  <message>
   <source>go to a finding first (F10)</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>请先转到一项检查结果（F10）</translation>
  </message>
  <message>
   <source>stopped checking the set; what was found stays</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>已停止检查数据集；已发现的结果保留</translation>
  </message>
  <message>
   <source>the label check has found nothing in this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>类别检查在本帧未发现问题</translation>
  </message>
  <message>
   <source>nothing found</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>未发现问题</translation>
  </message>
  <message>
   <source>no remedy is known: {reason}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>没有已知的修复：{reason}</translation>
  </message>
  <message>
   <source>cameras opened here before are not opened again: {why}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>之前在此打开的相机未再次打开：{why}</translation>
  </message>
  <message>
   <source>Open a video</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>打开视频</translation>
  </message>
  <message>
   <source>One frame every</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>取帧间隔</translation>
  </message>
  <message>
   <source>The first frame of every scene</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>每个场景的第一帧</translation>
  </message>
  <message>
   <source>Looks through the whole video for cuts; this takes a while</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>在整个视频中寻找剪切点；需要一些时间</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, the field american_football, the menus]</extracomment>
   <translation>场地</translation>
  </message>
  <message>
   <source>Reading {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>正在读取 {file}</translation>
  </message>
  <message>
   <source>Looking for cuts in {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>正在 {file} 中寻找剪切点</translation>
  </message>
  <message>
   <source>Pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>图片</translation>
  </message>
  <message>
   <source>Videos</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>视频</translation>
  </message>
  <message>
   <source>Nothing is extracted; “Keep this video frame” writes a picture.</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>不会导出任何内容；“保留此视频帧”可写出图片。</translation>
  </message>
  <message>
   <source>cameras opened here before are not there any more: {paths}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>之前在此打开的相机已不存在：{paths}</translation>
  </message>
  <message>
   <source>this frame is a picture already</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>本帧已是图片</translation>
  </message>
  <message>
   <source>kept as {path}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>已保留为 {path}</translation>
  </message>
  <message>
   <source>the sample comes with the source, not here</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/tour.py]</extracomment>
   <translation>示例随源代码提供，此处没有</translation>
  </message>
  <message>
   <source>your own copy, in {folder}; load its cameras from the menu Camera</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>您自己的副本，位于 {folder}；可从“相机”菜单加载其相机</translation>
  </message>
  <message>
   <source>Load a folder of cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>加载相机文件夹</translation>
  </message>
  <message>
   <source>Load cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>加载相机</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>相机</translation>
  </message>
  <message>
   <source>Open a folder of pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>打开图片文件夹</translation>
  </message>
  <message>
   <source>Open a picture</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>打开图片</translation>
  </message>
  <message>
   <source>Open a second annotator's folder</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>打开第二位标注者的文件夹</translation>
  </message>
  <message>
   <source>{width} x {height} px, without the legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px，不含图例</translation>
  </message>
  <message>
   <source>{width} x {height} px, too large: choose a smaller scale or SVG</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px，过大：请选择更小的比例或 SVG</translation>
  </message>
  <message>
   <source>PNG: pixels, nothing is lost</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>PNG：像素，无损</translation>
  </message>
  <message>
   <source>JPEG: pixels, small</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>JPEG：像素，体积小</translation>
  </message>
  <message>
   <source>SVG: lines and text stay sharp</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>SVG：线条和文字始终清晰</translation>
  </message>
  <message>
   <source>Picture (*{suffix})</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>图片 (*{suffix})</translation>
  </message>
  <message>
   <source>Save overlay picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>保存叠加图片</translation>
  </message>
  <message>
   <source>Px of the result per px of the picture; lines and text grow with it</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>结果 px 与图片 px 之比；线条和文字随之增大</translation>
  </message>
  <message>
   <source>Explain colours, dashes and marks below the picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>在图片下方说明颜色、线型和标记</translation>
  </message>
  <message>
   <source>&amp;Kind</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>类型(&amp;K)</translation>
  </message>
  <message>
   <source>&amp;Scale</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>比例(&amp;S)</translation>
  </message>
  <message>
   <source>Result</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>结果</translation>
  </message>
  <message>
   <source>&amp;Legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>图例(&amp;L)</translation>
  </message>
  <message>
   <source>writing the overlay picture {path} …</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>正在写出叠加图片 {path} …</translation>
  </message>
  <message>
   <source>open a picture first</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>请先打开图片</translation>
  </message>
  <message>
   <source>{path}: is the picture itself, choose another name</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{path}：就是图片本身，请另选名称</translation>
  </message>
  <message>
   <source>overlay picture written to {path}</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>叠加图片已写入 {path}</translation>
  </message>
  <message>
   <source>waiting</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>等待中</translation>
  </message>
  <message>
   <source>begun</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>已开始</translation>
  </message>
  <message>
   <source>done</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>完成</translation>
  </message>
  <message>
   <source>failed</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>失败</translation>
  </message>
  <message>
   <source>Match</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>比赛</translation>
  </message>
  <message>
   <source>Stadium</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>体育场</translation>
  </message>
  <message>
   <source>Start</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>开始时间</translation>
  </message>
  <message>
   <source>State</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>状态</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/commands/season.py, procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>帧</translation>
  </message>
  <message>
   <source>Tracked</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>已跟踪</translation>
  </message>
  <message>
   <source>On paint</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>画线吻合</translation>
  </message>
  <message>
   <source>Failed units</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>失败单元</translation>
  </message>
  <message>
   <source>Season</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>赛季</translation>
  </message>
  <message>
   <source>Search: match, stadium, state</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>搜索：比赛、体育场、状态</translation>
  </message>
  <message>
   <source>Tracked cameras…</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>已跟踪的相机…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} matches</source>
   <extracomment>{n:,} match / {n:,} matches [procc_annotator/gui/commands/season.py]</extracomment>
   <translation>
    <numerusform>{n:,} 场比赛</numerusform>
   </translation>
  </message>
  <message>
   <source>The folder that track writes to</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>track 写入的文件夹</translation>
  </message>
  <message>
   <source>Matches</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>比赛列表</translation>
  </message>
  <message>
   <source>open a season first: a folder in which videos lie, or a list of them</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>请先打开一个赛季：存放视频的文件夹，或视频列表</translation>
  </message>
  <message>
   <source>it is annotated by now</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>此时已标注</translation>
  </message>
  <message>
   <source>it was edited since</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>此后已编辑</translation>
  </message>
  <message>
   <source>no frame to accept: follow the shot first (T)</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>没有可接受的帧：请先跟踪镜头（T）</translation>
  </message>
  <message>
   <source>the shot is still being followed: wait for its end, or stop it (T), then accept</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>镜头仍在跟踪：请等待结束或停止（T），然后再接受</translation>
  </message>
  <message>
   <source>no frame to accept: all that were followed are annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>没有可接受的帧：已跟踪的帧均已标注</translation>
  </message>
  <message>
   <source>every frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>所有帧均已标注</translation>
  </message>
  <message>
   <source>blind mode: nothing is accepted that was not clicked</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>盲标模式：未点击的内容一律不接受</translation>
  </message>
  <message numerus="yes">
   <source>all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it / all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>全部 {n:,} 帧存疑（{why}）：请查看几帧；再按一次 Ctrl+Shift+Enter 即可接受</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points: {done} of {total} frames  ·  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>正在寻找线上的点：{done} / {total} 帧  ·  Esc 停止</translation>
  </message>
  <message>
   <source>accept elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>接受元素</translation>
  </message>
  <message>
   <source>take back accepted elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>撤回已接受的元素</translation>
  </message>
  <message numerus="yes">
   <source>annotated {n:,} frames</source>
   <extracomment>annotated {n:,} frame / annotated {n:,} frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>已标注 {n:,} 帧</numerusform>
   </translation>
  </message>
  <message>
   <source>Ctrl+Z takes them back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Ctrl+Z 撤回</translation>
  </message>
  <message numerus="yes">
   <source>taken back: {n:,} annotated frames</source>
   <extracomment>taken back: {n:,} annotated frame / taken back: {n:,} annotated frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>已撤回：{n:,} 个标注的帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames left: {why}</source>
   <extracomment>{n:,} frame left: {why} / {n:,} frames left: {why} [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>保留 {n:,} 帧：{why}</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points …  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>正在寻找线上的点 …  Esc 停止</translation>
  </message>
  <message>
   <source>no frame was annotated: too little of their lines is seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>未标注任何帧：可见的线太少</translation>
  </message>
  <message>
   <source>no frame was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>未接受任何帧：{why}</translation>
  </message>
  <message>
   <source>nothing was accepted that could be taken back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>没有可撤回的已接受内容</translation>
  </message>
  <message>
   <source>taken back: no frame is accepted</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>已撤回：不接受任何帧</translation>
  </message>
  <message>
   <source>no frame was annotated: no camera is sure</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>未标注任何帧：没有确定的相机</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first</source>
   <extracomment>{n:,} frame is not sure: Alt+PgDown shows it / {n:,} frames are not sure: Alt+PgDown goes through them, the least sure first [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧不确定：Alt+PgDown 逐个查看，最不确定的在前</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it / {n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>剩余 {n:,} 个存疑的帧：再按一次 Ctrl+Shift+Enter 即可接受</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera of this frame is unsure: a sure one is looked for in the shot; look at this one, accept its lines (Shift+Enter), then T follows them</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>本帧的相机不确定：正在镜头中查找确定的相机；请查看本帧并接受其线（Shift+Enter），之后按 T 跟踪</translation>
  </message>
  <message>
   <source>no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or {advice}; then T follows it</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>镜头中没有相机确定的帧：请接受某帧的线（Shift+Enter），或{advice}；之后按 T 跟踪</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>已跟踪 {n:,} 帧，其中 {doubtful:,} 帧存疑（Alt+PgDown）；Ctrl+Shift+回车接受确定的帧</numerusform>
   </translation>
  </message>
  <message>
   <source>following: {done} of {total} frames  ·  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>正在跟踪：{done} / {total} 帧  ·  T 停止</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>已跟踪 {n:,} 帧，全部确定；Ctrl+Shift+回车接受确定的帧</numerusform>
   </translation>
  </message>
  <message>
   <source>looking for the ends of the shot …  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>正在寻找镜头的两端 …  T 停止</translation>
  </message>
  <message>
   <source>the shot could not be followed: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>无法跟踪镜头：{why}</translation>
  </message>
  <message>
   <source>only a video, or frames that follow one another, can be followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>只有视频或连续的帧才能跟踪</translation>
  </message>
  <message>
   <source>blind mode: no shot is followed, its cameras would be seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>盲标模式：不跟踪镜头，否则会看到其相机</translation>
  </message>
  <message>
   <source>stopped; what was followed so far stays</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>已停止；目前的跟踪结果保留</translation>
  </message>
  <message>
   <source>stopped; nothing was followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>已停止；未跟踪任何内容</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>解锁会向所有标注者显示相机、虚影和拟合。数据集会记录 {author} 解锁及其时间。</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>解锁会向您显示相机、虚影和拟合；对其他人并未锁定。数据集会记录 {author} 解锁及其时间。</translation>
  </message>
  <message>
   <source>blind mode leaves out {n} on frames that are not committed</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>盲标模式排除未提交帧的 {n} 项</translation>
  </message>
  <message>
   <source>{frame}: no verdict on {source} any more</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{frame}：不再有对 {source} 的判定</translation>
  </message>
  <message>
   <source>Note on the verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>判定备注</translation>
  </message>
  <message>
   <source>What is wrong here:</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>这里有什么问题：</translation>
  </message>
  <message>
   <source>Export verdicts</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>导出判定</translation>
  </message>
  <message>
   <source>blind: no frame that is committed has a verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>盲标：没有已提交的帧有判定</translation>
  </message>
  <message>
   <source>no frame has a verdict yet: mark one first</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>尚无帧有判定：请先标记一个</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} verdicts to {path}</source>
   <extracomment>exported {n:,} verdict to {path} / exported {n:,} verdicts to {path} [procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>
    <numerusform>已将 {n:,} 项判定导出到 {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>mark the frame first: camera wrong, labels wrong or fine</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>请先标记本帧：相机错误、标注错误或无误</translation>
  </message>
  <message>
   <source>not everything could be saved: the figures are of the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>未能全部保存：数字为最近保存的状态</translation>
  </message>
  <message>
   <source>{source} follows the clicks: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} 随点击而变：判定针对加载的相机</translation>
  </message>
  <message>
   <source>{source} is worked out here: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} 在此计算得出：判定针对加载的相机</translation>
  </message>
  <message>
   <source>There is no earlier version of this frame.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>本帧没有早期版本。</translation>
  </message>
  <message>
   <source>Compared with now: {changes}. What differs: {elements}.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>与现在相比：{changes}。不同之处：{elements}。</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>无法读取</translation>
  </message>
  <message>
   <source>empty</source>
   <comment>a version</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>空</translation>
  </message>
  <message>
   <source>as now</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>与现在相同</translation>
  </message>
  <message>
   <source>other elements</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>元素不同</translation>
  </message>
  <message>
   <source>points moved</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>点有移动</translation>
  </message>
  <message>
   <source>This is what the frame holds now.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>这是本帧现在的内容。</translation>
  </message>
  <message>
   <source>Compared with now: the same points in another order of elements.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>与现在相比：点相同，元素顺序不同。</translation>
  </message>
  <message>
   <source>restore an earlier version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>恢复早期版本</translation>
  </message>
  <message>
   <source>Earlier versions</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>早期版本</translation>
  </message>
  <message>
   <source>Restore</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>恢复</translation>
  </message>
  <message>
   <source>%d %b %Y, %H:%M:%S</source>
   <comment>a moment; the month as %b is English, as %m a number</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>%Y-%m-%d %H:%M:%S</translation>
  </message>
  <message>
   <source>{n} more</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>另外 {n} 个</translation>
  </message>
  <message>
   <source>the earlier version is back; undo takes it away again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>已恢复早期版本；撤销可再次取消</translation>
  </message>
  <message>
   <source>the earlier version is back; what could not be read stays a version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>较早的版本已恢复；无法读取的内容保留为一个版本</translation>
  </message>
  <message>
   <source>the frame was changed elsewhere: look at it, then restore again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>该帧已在别处更改：请查看后再恢复</translation>
  </message>
  <message>
   <source>Frames of one instant from different cameras are one group. Their names tell which, by a pattern: &lt;b&gt;{instant}&lt;/b&gt; stands for when a frame was taken, &lt;b&gt;{view}&lt;/b&gt; for the camera, all else for itself. A regular expression with &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; and &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; does it, too.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>不同相机拍摄同一瞬间的帧为一组。由名称按模式判断：&lt;b&gt;{instant}&lt;/b&gt; 表示帧的拍摄时刻，&lt;b&gt;{view}&lt;/b&gt; 表示相机，其余字符表示其本身。也可用含 &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; 和 &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; 的正则表达式。</translation>
  </message>
  <message>
   <source>No pattern was found that fits these names: write one.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>未找到符合这些名称的模式：请写一个。</translation>
  </message>
  <message>
   <source>What it says now is lost, with everything else that is written in it.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>其现有内容及所写的其他一切都会丢失。</translation>
  </message>
  <message>
   <source>Instant</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>瞬间</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups of {least} to {most}</source>
   <extracomment>{frames} in {n:,} group of {least} to {most} / {frames} in {n:,} groups of {least} to {most} [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames}分为 {n:,} 组，每组 {least} 至 {most} 帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} of {n:,} instants</source>
   <extracomment>{frames} of {n:,} instant / {frames} of {n:,} instants [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个瞬间的{frames}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames, none grouped.</source>
   <extracomment>{n:,} frame, none grouped. / {n:,} frames, none grouped. [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧，均未分组。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups</source>
   <extracomment>{frames} in {n:,} group / {frames} in {n:,} groups [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames}分为 {n:,} 组</numerusform>
   </translation>
  </message>
  <message>
   <source>This name does not fit the pattern: the frame stands alone</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>此名称不符合模式：该帧单独存在</translation>
  </message>
  <message>
   <source>{file} groups {sizes} from now on</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} 从现在起将{sizes}分组</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} instants with one frame only</source>
   <extracomment>{n:,} instant with one frame only / {n:,} instants with one frame only [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个瞬间只有一帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} names do not fit (last in the table)</source>
   <extracomment>{n:,} name does not fit (last in the table) / {n:,} names do not fit (last in the table) [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个名称不符合（在表格末尾）</numerusform>
   </translation>
  </message>
  <message>
   <source>Group views</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>视图分组</translation>
  </message>
  <message>
   <source>{file} is there already: {sizes}.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} 已存在：{sizes}。</translation>
  </message>
  <message>
   <source>Write {file}</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>写出 {file}</translation>
  </message>
  <message>
   <source>Keep these groups in the dataset's folder</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>将这些分组保存在数据集的文件夹中</translation>
  </message>
  <message>
   <source>Groups of frames</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>帧的分组</translation>
  </message>
  <message>
   <source>Pattern of the frames' names</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>帧名的模式</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} 个元素，对称：{turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>还没有可显示的场地。</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}：{value:.10g} m（规则允许 {least:g} 至 {most:g} m）</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... 以及另外 {n} 个</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>无</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>在图片中按住的键</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>默认</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>左手</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>类似 CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>类似 labelme</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>滚轮</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>在光标处缩放</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>双指</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>平移；捏合则缩放</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Shift + 滚轮</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>横向平移，如同倾斜滚轮</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>空格 + 拖动</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>平移</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>中键</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>按住 X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>隐藏所有叠加层</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>按住 Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>放大镜：图片像素的八倍</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>按住 ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>查看对比的相机源</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>轻按 ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>用对比源评判，与当前源比较</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>按住 Ctrl</translation>
  </message>
  <message>
   <source>click off the line: no snapping</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>点在线旁：不吸附</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + 拖动线</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>相机：随之移动，该处成为固定桩</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + 点击固定桩</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>相机：移除固定桩</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/keymap.py, procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>方向键</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>十字光标：用键指点；若有选中的点则移动它们</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>十字光标处按空格</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>等同在该处点击（加 Ctrl：不吸附）</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>右键</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>光标下内容的菜单</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>回车</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>接受当前虚影</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Shift+回车</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>接受所有虚影</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>点击</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>绘制：添加点</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>双击</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>绘制：完成</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>拖动点</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：移动它</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Shift+点击点</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：选择多个</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>在空白处拖动</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：选择其中的点</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>拖动线</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：移动元素，除非元素已固定</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+点击线</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：插入点</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Shift+点击</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>编辑：移除该点</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>在帧条上点击或拖动</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>前往某帧</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>帧条上滚轮</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>缩放；加 Shift 则滚动</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>帧条上 Shift+拖动</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>标记区段（双击取消）</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>应为含 "actions" 和 "elements" 的对象</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" 和 "elements"：应为对象</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}：{value!r} 不是按键；应类似 {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}：应为按键列表，如 {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>面板</translation>
  </message>
  <message>
   <source>Choose another place…</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>选择其他位置…</translation>
  </message>
  <message>
   <source>Save copies to…</source>
   <extracomment>[procc_annotator/gui/messages.py, the action save_copies]</extracomment>
   <translation>副本保存到…</translation>
  </message>
  <message>
   <source>Copy details</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>复制详细信息</translation>
  </message>
  <message>
   <source>Show the next</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>显示下一个</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} 已存在，且内容不同。</translation>
  </message>
  <message numerus="yes">
   <source>{n} comments on this frame are not settled.</source>
   <extracomment>{n} comment on this frame is not settled. / {n} comments on this frame are not settled. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>本帧有 {n} 条评论未解决。</numerusform>
   </translation>
  </message>
  <message>
   <source>A tick in the Review panel settles a comment.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>在“审核”面板中勾选即表示评论已解决。</translation>
  </message>
  <message>
   <source>{n:,} of {total:,} frames are not done.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{total:,} 帧中有 {n:,} 帧未完成。</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} 帧未保存，刚才再次保存失败。</numerusform>
   </translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>显示文件中的内容；撤销可恢复您的版本</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>将屏幕上的内容覆盖写入文件</translation>
  </message>
  <message>
   <source>Export all</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>全部导出</translation>
  </message>
  <message>
   <source>Done only</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>仅已完成</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>关闭此消息</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>载入对方的版本</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>用我的覆盖</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>删除 {what}？</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>保留</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>删除</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>替换</translation>
  </message>
  <message>
   <source>Do not approve</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>不批准</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/review.py, the action approve]</extracomment>
   <translation>批准</translation>
  </message>
  <message>
   <source>Keep it locked</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>保持锁定</translation>
  </message>
  <message>
   <source>Unlock, and record it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>解锁并记录</translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>留下</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>关闭并丢失</translation>
  </message>
  <message>
   <source>Open a second annotator's folder (menu File) to compare the clicks of both.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>打开第二位标注者的文件夹（“文件”菜单），以比较两人的点击。</translation>
  </message>
  <message>
   <source>Apart: the two share (almost) no stretch of this element, which is no agreement. Was its class swapped with a neighbour's?</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>分离：两人在此元素上（几乎）没有共同区段，不算一致。是否与相邻元素的类别弄混了？</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks compared</source>
   <extracomment>{n:,} click compared / {n:,} clicks compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>已比较 {n:,} 次点击</numerusform>
   </translation>
  </message>
  <message>
   <source>{part} of {total}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{part} / {total}</translation>
  </message>
  <message>
   <source>apart</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>分离</translation>
  </message>
  <message numerus="yes">
   <source>{compared}, {n} left out: beyond the ends of what the other clicked</source>
   <extracomment>{compared}, {n} left out: beyond the ends of what the other clicked / {compared}, {n} left out: beyond the ends of what the other clicked [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{compared}，排除 {n} 次：超出对方所点的端点</numerusform>
   </translation>
  </message>
  <message>
   <source>Measuring the set…</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>正在测量数据集…</translation>
  </message>
  <message>
   <source>Distances by element</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>各元素的距离</translation>
  </message>
  <message>
   <source>Close the second annotator</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>关闭第二位标注者</translation>
  </message>
  <message>
   <source>The second annotator's file for this frame is unreadable: {error}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>第二位标注者在本帧的文件无法读取：{error}</translation>
  </message>
  <message>
   <source>Agreement JaC at {tau:g} px: {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{tau:g} px 下的一致性 JaC：{jac:.3f}</translation>
  </message>
  <message>
   <source>No element is annotated by both in any frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>没有任何一帧有两人都标注的元素。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames unreadable, not compared</source>
   <extracomment>{n:,} frame unreadable, not compared / {n:,} frames unreadable, not compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧无法读取，未比较</numerusform>
   </translation>
  </message>
  <message>
   <source>Median</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>中位数</translation>
  </message>
  <message>
   <source>Points</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows the score once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>已隐藏：盲标模式在提交本帧后显示得分。</translation>
  </message>
  <message>
   <source>One of the two seems to label the field turned by 180 degrees.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>其中一人似乎按旋转 180 度的场地标注。</translation>
  </message>
  <message>
   <source>Apart: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>分离：{elements}</translation>
  </message>
  <message>
   <source>Only here: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>仅此处：{elements}</translation>
  </message>
  <message>
   <source>Only there: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>仅对方：{elements}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks beyond the other's ends, left out</source>
   <extracomment>{n:,} click beyond the other's ends, left out / {n:,} clicks beyond the other's ends, left out [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} 次点击超出对方的端点，已排除</numerusform>
   </translation>
  </message>
  <message>
   <source>Nothing to measure noise by: all elements annotated by both are apart.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>无可测量噪声的内容：两人都标注的元素均分离。</translation>
  </message>
  <message numerus="yes">
   <source>Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height})</source>
   <extracomment>Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) / Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧上的人为噪声：中位数 {median:.2f} px，95 % 在 {p95:.2f} px 以内（{width}x{height}）</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>and {n} more</source>
   <extracomment>and {n} more / and {n} more [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>以及另外 {n} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>The second annotator has nothing for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>第二位标注者在本帧没有内容。</translation>
  </message>
  <message>
   <source>Frames of this dataset that have a camera (completeness)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>本数据集中有相机的帧（完整度）</translation>
  </message>
  <message>
   <source>Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the fit was made from.
procc-annotator calibrate fits and scores the whole set</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>本窗口中访问过且点击得出相机的帧；其 JaC 针对用于拟合的点击。
procc-annotator calibrate 可拟合并评分整个数据集</translation>
  </message>
  <message>
   <source>Frames of this dataset that were followed through their shot and have a camera.
procc-annotator track follows a whole video and writes its cameras</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>本数据集中随镜头跟踪并有相机的帧。
procc-annotator track 可跟踪整个视频并写出其相机</translation>
  </message>
  <message>
   <source>Yellow</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>黄色</translation>
  </message>
  <message>
   <source>Violet</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>紫色</translation>
  </message>
  <message>
   <source>Blue</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>蓝色</translation>
  </message>
  <message>
   <source>Mint</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>薄荷色</translation>
  </message>
  <message>
   <source>Navy</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>藏青色</translation>
  </message>
  <message>
   <source>Cyan</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>青色</translation>
  </message>
  <message>
   <source>Switch the live fit off (Ctrl+T switches it on again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>关闭实时拟合（Ctrl+T 再次打开）</translation>
  </message>
  <message>
   <source>Name of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>源的名称</translation>
  </message>
  <message>
   <source>Draw as a wireframe while another source is judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>评判其他源时以线框绘制</translation>
  </message>
  <message>
   <source>Mean JaC at {tau:.1f} px over {frames}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{frames}在 {tau:.1f} px 下的平均 JaC</translation>
  </message>
  <message>
   <source>Unreadable (filter camera:unreadable): {names}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>无法读取（筛选 camera:unreadable）：{names}</translation>
  </message>
  <message numerus="yes">
   <source>{matched} of {total}, {n} unreadable</source>
   <extracomment>{matched} of {total}, {n} unreadable / {matched} of {total}, {n} unreadable [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{matched} / {total}，{n} 个无法读取</numerusform>
   </translation>
  </message>
  <message>
   <source>Remove from the list; the files stay</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>从列表移除；文件保留</translation>
  </message>
  <message>
   <source>Forget what was followed (T follows the shot again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>忘记跟踪结果（T 重新跟踪镜头）</translation>
  </message>
  <message>
   <source>Judge nothing, draw no camera</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>不评判，不绘制相机</translation>
  </message>
  <message>
   <source>Judge against {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>评判 {name}</translation>
  </message>
  <message>
   <source>Remove {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>移除 {name}</translation>
  </message>
  <message>
   <source>Draw {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>绘制 {name}</translation>
  </message>
  <message>
   <source>Colour of {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} 的颜色</translation>
  </message>
  <message>
   <source>{frames} so far</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>目前 {frames}</translation>
  </message>
  <message numerus="yes">
   <source>{mean}; {n:,} cameras cannot be read and take no part</source>
   <extracomment>{mean}; {n:,} camera cannot be read and takes no part / {mean}; {n:,} cameras cannot be read and take no part [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{mean}；{n:,} 个相机无法读取，不参与计算</numerusform>
   </translation>
  </message>
  <message>
   <source>{model} (ground)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model}（地面）</translation>
  </message>
  <message>
   <source>{model} here</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>此处 {model}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames followed</source>
   <extracomment>{n:,} frame followed / {n:,} frames followed [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>已跟踪 {n:,} 帧</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} opened frames</source>
   <extracomment>{n:,} opened frame / {n:,} opened frames [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>已打开 {n:,} 帧</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ({share})</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{n} / {total}（{share}）</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n:,} more</source>
   <extracomment>{names} and {n:,} more / {names} and {n:,} more [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{names} 以及另外 {n:,} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>cannot be used here: {error}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>此处无法使用：{error}</translation>
  </message>
  <message>
   <source>no camera for this frame</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>本帧无相机</translation>
  </message>
  <message>
   <source>Other…</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>其他…</translation>
  </message>
  <message>
   <source>Colour of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>源的颜色</translation>
  </message>
  <message>
   <source>Double-click or F2 gives it another name</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>双击或 F2 更改名称</translation>
  </message>
  <message>
   <source>Blind mode hides how the sources do</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>盲标模式隐藏各源的表现</translation>
  </message>
  <message>
   <source>No frame has both annotated elements and a camera of this source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>没有任何一帧既有标注元素又有此源的相机</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} cameras</source>
   <extracomment>{n:,} camera / {n:,} cameras [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个相机</numerusform>
   </translation>
  </message>
  <message>
   <source>none judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>不评判</translation>
  </message>
  <message>
   <source>several models</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>多种模型</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the setting protocol]</extracomment>
   <translation>soccernet（官方）</translation>
  </message>
  <message>
   <source>procc (paper)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>procc（论文）</translation>
  </message>
  <message>
   <source>count as missed</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>计为未命中</translation>
  </message>
  <message>
   <source>are left out</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>排除在外</translation>
  </message>
  <message>
   <source>Cameras ({endings});;All files (*)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>相机 ({endings});;所有文件 (*)</translation>
  </message>
  <message>
   <source>Source to compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>要对比的源</translation>
  </message>
  <message>
   <source>Compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>对比</translation>
  </message>
  <message>
   <source>{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>{share:.0f} % 在 {far:g} m 以内，占图片的 {covered:.0f} %</translation>
  </message>
  <message>
   <source>No cameras loaded.
Load a folder of camera files or homographies to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>未加载相机。
加载相机文件或单应矩阵的文件夹，即可用您的点击评判它们。</translation>
  </message>
  <message>
   <source>Load folder…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>加载文件夹…</translation>
  </message>
  <message>
   <source>Load file…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>加载文件…</translation>
  </message>
  <message>
   <source>Read as</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>读取方式</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the menus, the setting protocol]</extracomment>
   <translation>协议</translation>
  </message>
  <message>
   <source>Off the ground</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>离地</translation>
  </message>
  <message>
   <source>This frame: {notice}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>本帧：{notice}</translation>
  </message>
  <message>
   <source>⚠ This frame's camera cannot be used: {error}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>⚠ 本帧的相机无法使用：{error}</translation>
  </message>
  <message>
   <source>Held against the active source: comma, split view, disagreement</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>与当前源对照：逗号、分割视图、分歧</translation>
  </message>
  <message>
   <source>min</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>最小</translation>
  </message>
  <message>
   <source>median</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>中位数</translation>
  </message>
  <message>
   <source>max</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>on the ground, m</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>地面上，m</translation>
  </message>
  <message>
   <source>in the picture, px</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>图片中，px</translation>
  </message>
  <message>
   <source>A folder with one camera file a frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>每帧一个相机文件的文件夹</translation>
  </message>
  <message>
   <source>A zip archive of cameras, or the camera of one frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>相机的 zip 压缩包，或单帧的相机</translation>
  </message>
  <message>
   <source>How the files loaded next are read</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>接下来加载的文件如何读取</translation>
  </message>
  <message>
   <source>soccernet: the official evaluation with its quirks
procc: the paper's definition, closed circles and fine curves</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>soccernet：官方评测及其怪癖
procc：论文的定义，闭合的圆和精细的曲线</translation>
  </message>
  <message>
   <source>A homography knows the ground only: how posts and crossbars count for it</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>单应矩阵只知道地面：门柱和横梁对它如何计入</translation>
  </message>
  <message>
   <source>Between the two points on the ground that a pixel means</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>一个像素所指的两个地面点之间的距离</translation>
  </message>
  <message>
   <source>From a pixel to where the compared camera shows its ground point</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>从一个像素到对比相机显示其地面点之处</translation>
  </message>
  <message>
   <source>annotated</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py, procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>已标注</translation>
  </message>
  <message>
   <source>unconfirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>未确认</translation>
  </message>
  <message>
   <source>not visible</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>不可见</translation>
  </message>
  <message>
   <source>next</source>
   <comment>element</comment>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>下一个</translation>
  </message>
  <message>
   <source>Not annotated in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>本帧中未标注</translation>
  </message>
  <message>
   <source>Annotated, but not judged: no camera is shown, or it takes no part in the evaluation</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>已标注但未评判：没有显示相机，或其不参与评测</translation>
  </message>
  <message>
   <source>Copied; it does not count until it is touched or confirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>复制所得；改动或确认之前不计入</translation>
  </message>
  <message>
   <source>Passes: all its points are closer than tau to the projection</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>通过：所有点到投影的距离都小于 tau</translation>
  </message>
  <message>
   <source>Too far: at least one point is tau or more away (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>过远：至少一个点的距离达到或超过 tau（假阳性）</translation>
  </message>
  <message>
   <source>The camera projects it, it is not annotated (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>相机投影了它，但未标注（假阳性）</translation>
  </message>
  <message>
   <source>Annotated, the camera does not project it (false negative)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>已标注，但相机未投影（假阴性）</translation>
  </message>
  <message>
   <source>Marked as not visible in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>有人标明它在本帧不可见</translation>
  </message>
  <message>
   <source>To be annotated next, as on the field map and in the picture</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>接下来应标注，如场地图和图片所示</translation>
  </message>
  <message>
   <source>{title} (unknown class)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>{title}（未知类别）</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>无几何</translation>
  </message>
  <message>
   <source>Unknown to the field (unknown classes)</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>场地未知（未知类别）</translation>
  </message>
  <message>
   <source>Find an element</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>查找元素</translation>
  </message>
  <message>
   <source>No element matches “{query}”.
Esc clears the search.</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>没有元素匹配“{query}”。
按 Esc 清除搜索。</translation>
  </message>
  <message>
   <source>Annotated points</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>已标注的点</translation>
  </message>
  <message>
   <source>{title}
Class in files: {name}</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>{title}
文件中的类别：{name}</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>元素</translation>
  </message>
  <message>
   <source>Key</source>
   <comment>keyboard</comment>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>按键</translation>
  </message>
  <message>
   <source>Pts</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>点数</translation>
  </message>
  <message>
   <source>Status</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>状态</translation>
  </message>
  <message>
   <source>Annotating it next helps most: the projection is then known to {after:.1f} px instead of {before:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>接下来标注它最有用：投影的精度将从 {before:.1f} px 提高到 {after:.1f} px</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>场地图</translation>
  </message>
  <message>
   <source>The arrows choose elements</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>方向键选择元素</translation>
  </message>
  <message>
   <source>far</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>远</translation>
  </message>
  <message>
   <source>right</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>右</translation>
  </message>
  <message>
   <source>near</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>近</translation>
  </message>
  <message>
   <source>left</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>左</translation>
  </message>
  <message>
   <source>Next: {title}, {before:.1f} → {after:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>下一个：{title}，{before:.1f} → {after:.1f} px</translation>
  </message>
  <message>
   <source>Click an element</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>点击元素</translation>
  </message>
  <message>
   <source>{shown:,} of {frames}</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>{shown:,} / {frames}</translation>
  </message>
  <message>
   <source>Show all frames</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py]</extracomment>
   <translation>显示所有帧</translation>
  </message>
  <message>
   <source>Error</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>错误</translation>
  </message>
  <message>
   <source>Warning</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>警告</translation>
  </message>
  <message>
   <source>Hint</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>提示</translation>
  </message>
  <message>
   <source>Nothing found in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>本帧未发现问题。</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found in {n:,} frames.</source>
   <extracomment>Nothing found in {n:,} frame. / Nothing found in {n:,} frames. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧中未发现问题。</numerusform>
   </translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures to check their labels.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>没有帧。
打开图片文件夹以检查其类别。</translation>
  </message>
  <message>
   <source>Nothing is annotated in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>本帧没有任何标注。</translation>
  </message>
  <message>
   <source>No problems so far.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>目前没有问题。</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found but {n:,} ignored findings.</source>
   <extracomment>Nothing found but {n:,} ignored finding. / Nothing found but {n:,} ignored findings. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>除 {n:,} 项已忽略的结果外未发现问题。</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>盲标：需要相机的检查等到提交本帧后进行（Ctrl+回车）。</translation>
  </message>
  <message>
   <source>The live fit is off: the full check needs it.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>实时拟合已关闭：完整检查需要它。</translation>
  </message>
  <message>
   <source>Full check needs a camera: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>完整检查需要相机：{why}。</translation>
  </message>
  <message>
   <source>Blind: only committed frames are checked with a camera.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>盲标：只对已提交的帧用相机检查。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked, such as {name}: {why}</source>
   <extracomment>{n:,} frame cannot be checked, such as {name}: {why} / {n:,} frames cannot be checked, such as {name}: {why} [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧无法检查，如 {name}：{why}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>The set is not checked yet; {n:,} frames checked so far.</source>
   <extracomment>The set is not checked yet; {n:,} frame checked so far. / The set is not checked yet; {n:,} frames checked so far. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>数据集尚未检查；目前已查看 {n:,} 帧。</numerusform>
   </translation>
  </message>
  <message>
   <source>List the findings of all checked frames, errors first, or of this frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>列出所有已检查帧的检查结果（错误在前），或仅本帧的</translation>
  </message>
  <message>
   <source>Frames checked</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>已检查的帧</translation>
  </message>
  <message>
   <source>Checking this frame…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>正在检查本帧…</translation>
  </message>
  <message>
   <source>Checking the set…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>正在检查数据集…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} errors</source>
   <extracomment>{n:,} error / {n:,} errors [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个错误</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} warnings</source>
   <extracomment>{n:,} warning / {n:,} warnings [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个警告</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} hints</source>
   <extracomment>{n:,} hint / {n:,} hints [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个提示</numerusform>
   </translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>检查整个数据集</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} more are not listed: switch the signs above on.</source>
   <extracomment>{n:,} more is not listed: switch the signs above on. / {n:,} more are not listed: switch the signs above on. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>另有 {n:,} 项未列出：请打开上方的标志。</numerusform>
   </translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action ignore_finding]</extracomment>
   <translation>在其元素的点改变之前不再显示</translation>
  </message>
  <message>
   <source>Findings</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>检查结果</translation>
  </message>
  <message>
   <source>Whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>整个数据集</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>在所有已标注的帧中查找错误类别</translation>
  </message>
  <message>
   <source>Write the findings of all checked frames as CSV</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>将所有已检查帧的检查结果写为 CSV</translation>
  </message>
  <message>
   <source>{findings}; click to list them or not</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>{findings}；点击以列出或隐藏</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt;</source>
   <extracomment>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; / {n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>此处已忽略 {n:,} 项。&lt;a href="restore"&gt;重新显示&lt;/a&gt;</numerusform>
   </translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/menus.py, the action ignore_finding]</extracomment>
   <translation>忽略此检查结果</translation>
  </message>
  <message>
   <source>Mean</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>平均</translation>
  </message>
  <message>
   <source>Largest</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>Worst first; a click shows the worst point</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>最差的在前；点击显示最差的点</translation>
  </message>
  <message>
   <source>Mean distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>其点到拟合元素的平均距离，以图片 px 计</translation>
  </message>
  <message>
   <source>Largest distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>其点到拟合元素的最大距离，以图片 px 计</translation>
  </message>
  <message>
   <source>{model}. Chosen: {why}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{model}。选择依据：{why}</translation>
  </message>
  <message numerus="yes">
   <source>{passing} of {n:,} annotated elements within {px:g} px</source>
   <extracomment>{passing} of {n:,} annotated element within {px:g} px / {passing} of {n:,} annotated elements within {px:g} px [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个标注元素中有 {passing} 个在 {px:g} px 以内</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{counted}; {n} in sight not annotated yet</source>
   <extracomment>{counted}; {n} in sight not annotated yet / {counted}; {n} in sight not annotated yet [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{counted}；另有 {n} 个可见但尚未标注</numerusform>
   </translation>
  </message>
  <message>
   <source>{title}: mean {mean} px, largest {largest} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{title}：平均 {mean} px，最大 {largest} px</translation>
  </message>
  <message>
   <source>Taken for a mistake: it had no say in the fit</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>视为错误：未参与拟合</translation>
  </message>
  <message>
   <source>Elements in sight that are not annotated count against the JaC</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>可见但未标注的元素会拉低 JaC</translation>
  </message>
  <message>
   <source>Hardly determined: {limits}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>难以确定：{limits}</translation>
  </message>
  <message>
   <source>Mean distance of the points that had a say, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>参与拟合的点的平均距离，以图片 px 计</translation>
  </message>
  <message>
   <source>Standard deviation, as the fit estimates it</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>由拟合估计的标准差</translation>
  </message>
  <message>
   <source>Save as the frame's camera</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>保存为本帧的相机</translation>
  </message>
  <message>
   <source>✕ left out: {title}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>✕ 已排除：{title}</translation>
  </message>
  <message>
   <source>Pan</source>
   <comment>an angle</comment>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>水平转动</translation>
  </message>
  <message>
   <source>Tilt</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>俯仰</translation>
  </message>
  <message>
   <source>Roll</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>横滚</translation>
  </message>
  <message>
   <source>Focal length</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>焦距</translation>
  </message>
  <message>
   <source>Along (x)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>纵向 (x)</translation>
  </message>
  <message>
   <source>Across (y)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>横向 (y)</translation>
  </message>
  <message>
   <source>Height (−z)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>高度 (−z)</translation>
  </message>
  <message>
   <source>Model</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>模型</translation>
  </message>
  <message>
   <source>Residuals by element</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>各元素的残差</translation>
  </message>
  <message>
   <source>No camera yet: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>尚无相机：{why}。</translation>
  </message>
  <message>
   <source>Fitting the clicks…</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>正在拟合点击…</translation>
  </message>
  <message>
   <source>No fit.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>没有拟合。</translation>
  </message>
  <message>
   <source>JaC at {tau:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py, procc_annotator/gui/panels/plots/pages.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{tau:.1f} px 下的 JaC</translation>
  </message>
  <message>
   <source>&lt;b&gt;Hardly determined&lt;/b&gt;: {what}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>&lt;b&gt;难以确定&lt;/b&gt;：{what}</translation>
  </message>
  <message>
   <source>JaC: {terms}; residuals: px of the picture, {width}x{height}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>JaC：{terms}；残差：图片 px，{width}x{height}</translation>
  </message>
  <message>
   <source>What is fitted. Automatically: the simplest model that the clicks support</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>拟合什么。自动：点击所能支持的最简模型</translation>
  </message>
  <message>
   <source>mean residual</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>平均残差</translation>
  </message>
  <message numerus="yes">
   <source>{n} open</source>
   <extracomment>{n} open / {n} open [procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n} 个未处理</numerusform>
   </translation>
  </message>
  <message>
   <source>all done</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>全部完成</translation>
  </message>
  <message>
   <source>not annotated</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>未标注</translation>
  </message>
  <message>
   <source>⚠ unreadable</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ 无法读取</translation>
  </message>
  <message>
   <source>⚠ camera</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ 相机</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} done</source>
   <extracomment>{n:,} done / {n:,} done [procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>
    <numerusform>{n:,} 帧完成</numerusform>
   </translation>
  </message>
  <message>
   <source>● not saved</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>● 未保存</translation>
  </message>
  <message>
   <source>the picture cannot be read</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>图片无法读取</translation>
  </message>
  <message>
   <source>mean JaC {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>平均 JaC {jac:.3f}</translation>
  </message>
  <message>
   <source>folded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>已折叠</translation>
  </message>
  <message>
   <source>unfolded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>已展开</translation>
  </message>
  <message>
   <source>Filter frames</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>筛选帧</translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures (jpg, png, bmp, webp), or drop one here.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>没有帧。
打开图片文件夹（jpg、png、bmp、webp），或拖放到此处。</translation>
  </message>
  <message>
   <source>Nothing matches “{query}”.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>没有内容匹配“{query}”。</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} folders</source>
   <extracomment>{frames} in {n:,} folder / {frames} in {n:,} folders [procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个文件夹中的{frames}</numerusform>
   </translation>
  </message>
  <message>
   <source>No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the corner of a board, a floodlight. Name one below, and click it in two calibrated views.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>没有地标。地标是此体育场中场地描述所没有的位置：座椅、广告牌的角、照明灯。在下方命名一个，并在两个已标定的视图中点击它。</translation>
  </message>
  <message>
   <source>Find its place from the views it is clicked in; cameras are those of the active source, else fits to the clicks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>由点击它的视图求出其位置；相机取自当前源，否则为对点击的拟合</translation>
  </message>
  <message>
   <source>Other views of this instant</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>此瞬间的其他视图</translation>
  </message>
  <message>
   <source>No other views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>没有其他视图</translation>
  </message>
  <message>
   <source>Its place cannot be brought back with undo. Clicks on it stay in the annotations.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>其位置无法通过撤销恢复。对它的点击保留在标注中。</translation>
  </message>
  <message>
   <source>Landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>地标</translation>
  </message>
  <message>
   <source>Views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>视图</translation>
  </message>
  <message>
   <source>Triangulated from {frames}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>由 {frames} 三角测量得出</translation>
  </message>
  <message>
   <source>Other views of this instant: go to one with a click</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>此瞬间的其他视图：点击前往</translation>
  </message>
  <message>
   <source>{title} is clicked in no frame yet: click it in two calibrated views to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} 尚未在任何帧中点击：请在两个已标定的视图中点击以进行三角测量。</translation>
  </message>
  <message>
   <source>Clicked here, but no landmarks yet: {names}. Write a name next to Add to triangulate it.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>在此点击但尚非地标：{names}。请在“添加”旁写名称以进行三角测量。</translation>
  </message>
  <message>
   <source>Its place is not known yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>其位置尚不可知</translation>
  </message>
  <message>
   <source>Surveyed</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>实测</translation>
  </message>
  <message>
   <source>New landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>新地标</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/panels/review.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>添加</translation>
  </message>
  <message>
   <source>What people call it</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>通常的叫法</translation>
  </message>
  <message>
   <source>x, y, z in metres, z down</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>x、y、z，以米计，z 向下</translation>
  </message>
  <message>
   <source>Set</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>设定</translation>
  </message>
  <message>
   <source>Triangulate</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>三角测量</translation>
  </message>
  <message>
   <source>Standard deviation in the direction where it is largest</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>最大方向上的标准差</translation>
  </message>
  <message>
   <source>{name} is being triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>正在对 {name} 进行三角测量。</translation>
  </message>
  <message>
   <source>{why}. Delete the landmark and name it again to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{why}。请删除该地标并重新命名，以进行三角测量。</translation>
  </message>
  <message>
   <source>Looking for the frames in which {title} is clicked…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>正在寻找点击了 {title} 的帧…</translation>
  </message>
  <message>
   <source>{title} is clicked in {frame} alone: click it in another calibrated view to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} 只在 {frame} 中点击：请在另一个已标定的视图中点击以进行三角测量。</translation>
  </message>
  <message>
   <source>Choose a landmark in the list to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>在列表中选择地标以进行三角测量。</translation>
  </message>
  <message>
   <source>Only a landmark that has a name can be triangulated: write one next to Add.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>只有有名称的地标才能进行三角测量：请在“添加”旁写一个。</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n} more</source>
   <extracomment>{names} and {n} more / {names} and {n} more [procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>
    <numerusform>{names} 以及另外 {n} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>地标</translation>
  </message>
  <message>
   <source>Have a new landmark, to be clicked (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>新建地标以供点击（回车）</translation>
  </message>
  <message>
   <source>The place was measured: it stays as it is from now on (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>该位置为实测：从现在起保持不变（回车）</translation>
  </message>
  <message>
   <source>Forget this landmark; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>忘记此地标；对它的点击保留在标注中</translation>
  </message>
  <message>
   <source>Title</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>名称</translation>
  </message>
  <message>
   <source>Place</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>位置</translation>
  </message>
  <message>
   <source>Not clicked in any frame yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>尚未在任何帧中点击</translation>
  </message>
  <message>
   <source>Triangulating…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>正在三角测量…</translation>
  </message>
  <message>
   <source>a landmark needs a name: write one next to Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>地标需要名称：请在“添加”旁写一个</translation>
  </message>
  <message>
   <source>deleted the landmark {title}; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>已删除地标 {title}；对它的点击保留在标注中</translation>
  </message>
  <message>
   <source>the landmark {title}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>地标 {title}</translation>
  </message>
  <message>
   <source>Picture (*.png);;Vector graphics (*.svg)</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>图片 (*.png);;矢量图 (*.svg)</translation>
  </message>
  <message>
   <source>the plotted numbers are on the clipboard</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>图表的数值已复制到剪贴板</translation>
  </message>
  <message>
   <source>Save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>保存图表</translation>
  </message>
  <message>
   <source>wrote {path}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>已写出 {path}，截至已评分部分</translation>
  </message>
  <message>
   <source>wrote {path}</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>已写出 {path}</translation>
  </message>
  <message>
   <source>the plot is on the clipboard as a picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>图表已作为图片复制到剪贴板</translation>
  </message>
  <message>
   <source>there is nothing plotted to take along</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>没有可带走的图表</translation>
  </message>
  <message>
   <source>{frames}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{frames}，截至已评分部分</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows committed frames only, and none of them is in this plot.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>已隐藏：盲标模式只显示已提交的帧，而此图表中没有。</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows this plot once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>已隐藏：盲标模式在提交本帧后显示此图表。</translation>
  </message>
  <message>
   <source>Sources: {names}</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>源：{names}</translation>
  </message>
  <message>
   <source>Shots are recognized by names, since {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>镜头按名称识别，因为{error}。</translation>
  </message>
  <message>
   <source>JaC over tau</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC 随 tau 变化</translation>
  </message>
  <message>
   <source>JaC over the frames</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>各帧的 JaC</translation>
  </message>
  <message>
   <source>No scores yet. They are computed in the background, frame by frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>尚无得分。正在后台逐帧计算。</translation>
  </message>
  <message>
   <source>Errors, as a histogram</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>误差直方图</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points without a distance left out.</source>
   <extracomment>{n:,} point without a distance left out. / {n:,} points without a distance left out. [procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>
    <numerusform>{n:,} 个没有距离的点已排除。</numerusform>
   </translation>
  </message>
  <message>
   <source>Residuals over the picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>图片上的残差</translation>
  </message>
  <message>
   <source>tau (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau (px)</translation>
  </message>
  <message>
   <source>frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>帧</translation>
  </message>
  <message>
   <source>{name} (frame {n})</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name}（第 {n} 帧）</translation>
  </message>
  <message>
   <source>No score of this frame: it is not annotated, or no shown source has its camera.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>本帧没有得分：未标注，或显示的源都没有其相机。</translation>
  </message>
  <message>
   <source>reprojection error (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>重投影误差 (px)</translation>
  </message>
  <message>
   <source>points</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>How many times longer than they are arrows are drawn</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>箭头绘制为实际长度的多少倍</translation>
  </message>
  <message>
   <source>Arrows drawn longer</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>箭头放大绘制</translation>
  </message>
  <message>
   <source>The last bar holds all larger errors.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>最后一条包含所有更大的误差。</translation>
  </message>
  <message>
   <source>{px:g} px or more</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{px:g} px 或更大</translation>
  </message>
  <message>
   <source>{name} {part:,} of {total:,}</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} {part:,} / {total:,}</translation>
  </message>
  <message>
   <source>No point of {element} in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>本帧没有 {element} 的点。</translation>
  </message>
  <message>
   <source>No point of {element} so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>目前没有 {element} 的点。</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>本帧没有被显示源投影的标注点。</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>目前没有被显示源投影的标注点。</translation>
  </message>
  <message>
   <source>automatic</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>自动</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: from the click towards the projection.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>箭头为实际长度的 {factor} 倍：从点击指向投影。</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: the median residual of each part of the picture with 5 points or more.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>箭头为实际长度的 {factor} 倍：图片中每个有 5 个或更多点的部分的残差中位数。</translation>
  </message>
  <message>
   <source>Each curve is the mean of the frames that source has a camera for.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>每条曲线是该源有相机的帧的平均。</translation>
  </message>
  <message>
   <source>Shaded: 95 % bands, {drawn}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>阴影：95 % 带，{drawn}。</translation>
  </message>
  <message>
   <source>tau {px:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau {px:.1f} px</translation>
  </message>
  <message>
   <source>Too few points so far: five in a part of the picture make an arrow.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>点尚太少：图片的一个部分有五个点才成一个箭头。</translation>
  </message>
  <message>
   <source>This frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>本帧</translation>
  </message>
  <message>
   <source>Copy or save the plot and its numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>复制或保存图表及其数值</translation>
  </message>
  <message>
   <source>Plot the points of one element only</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>只绘制一个元素的点</translation>
  </message>
  <message>
   <source>({n:,} of {total:,})</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（{n:,} / {total:,}）</translation>
  </message>
  <message>
   <source>All elements</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>所有元素</translation>
  </message>
  <message>
   <source>Plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>图表</translation>
  </message>
  <message>
   <source>This plot could not be computed: {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>无法计算此图表：{error}。</translation>
  </message>
  <message>
   <source>({n:,} committed)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（已提交 {n:,}）</translation>
  </message>
  <message>
   <source>Copy or save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>复制或保存图表</translation>
  </message>
  <message>
   <source>Copy picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>复制图片</translation>
  </message>
  <message>
   <source>Copy numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>复制数值</translation>
  </message>
  <message>
   <source>Save picture…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>保存图片…</translation>
  </message>
  <message>
   <source>Save numbers…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>保存数值…</translation>
  </message>
  <message>
   <source>Plot the frame on screen, or all frames scored so far</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>绘制屏幕上的帧，或目前已评分的所有帧</translation>
  </message>
  <message>
   <source>Computing…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>正在计算…</translation>
  </message>
  <message>
   <source>(hidden)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（已隐藏）</translation>
  </message>
  <message>
   <source>(no score)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（无得分）</translation>
  </message>
  <message>
   <source>Save</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>保存</translation>
  </message>
  <message>
   <source>Committed in blind mode, and as it was then.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>以盲标模式提交，且此后未变。</translation>
  </message>
  <message>
   <source>Edited after the cameras were shown.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>在显示相机之后编辑过。</translation>
  </message>
  <message>
   <source>{seconds} s</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{seconds} 秒</translation>
  </message>
  <message>
   <source>How the points of this frame came to be</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>本帧的点如何产生</translation>
  </message>
  <message>
   <source>Add the comment to the thread (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>将评论加入讨论（回车）</translation>
  </message>
  <message>
   <source>Committed in blind mode by {author}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{author} 以盲标模式提交</translation>
  </message>
  <message>
   <source>{minutes}:{seconds:02d} min</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{minutes}:{seconds:02d} 分</translation>
  </message>
  <message>
   <source>This frame is right (Ctrl+Shift+A)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>本帧正确（Ctrl+Shift+A）</translation>
  </message>
  <message>
   <source>Send it back (Ctrl+Shift+X)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>退回（Ctrl+Shift+X）</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[procc_annotator/gui/panels/review.py, the action reject]</extracomment>
   <translation>退回</translation>
  </message>
  <message>
   <source>No comments on this frame.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>本帧没有评论。</translation>
  </message>
  <message>
   <source>Comment on this place</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>对此处的评论</translation>
  </message>
  <message>
   <source>{frame} is {status}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{frame} 为“{status}”</translation>
  </message>
  <message>
   <source>{frame} is {status} again</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} 又是“{status}”了</translation>
  </message>
  <message>
   <source>Time worked on this frame; pauses over 30 s do not count</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>在本帧上的工作时间；超过 30 秒的停顿不计</translation>
  </message>
  <message>
   <source>Comments</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>评论</translation>
  </message>
  <message>
   <source>Points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>点：{kinds}</translation>
  </message>
  <message>
   <source>Points: none</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>点：无</translation>
  </message>
  <message numerus="yes">
   <source>to be confirmed (Shift+V): {n:,} elements</source>
   <extracomment>to be confirmed (Shift+V): {n:,} element / to be confirmed (Shift+V): {n:,} elements [procc_annotator/gui/panels/review.py]</extracomment>
   <translation>
    <numerusform>待确认（Shift+V）：{n:,} 个元素</numerusform>
   </translation>
  </message>
  <message>
   <source>Comment on this frame</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>对本帧的评论</translation>
  </message>
  <message>
   <source>Ticked: settled</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>勾选：已解决</translation>
  </message>
  <message>
   <source>somebody</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/editing/batch_edits.py, procc_annotator/gui/state/state.py]</extracomment>
   <translation>某人</translation>
  </message>
  <message>
   <source>Choose an element to read why it counts as it does.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>选择一个元素，以了解其如此计入的原因。</translation>
  </message>
  <message>
   <source>the camera is the fit to these same clicks: this JaC is no score of a method</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>该相机就是对这些点击的拟合：此 JaC 不是任何方法的得分</translation>
  </message>
  <message>
   <source>Mirrored labels count here: the field turned by 180° fits at least as well.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>此处按镜像类别计：旋转 180° 的场地至少同样吻合。</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>人为噪声 {median:.2f} px，95 % 在 {p95:.2f} px 以内</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>人为噪声 {median:.2f} px，95 % 在 {p95:.2f} px 以内，超过 tau</translation>
  </message>
  <message>
   <source>Point</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>Worst</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>最差</translation>
  </message>
  <message>
   <source>Passes at</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>通过于</translation>
  </message>
  <message>
   <source>Click a row to see the point that decides</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>点击一行查看起决定作用的点</translation>
  </message>
  <message>
   <source>How the element counts at tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>元素在 tau 下如何计入</translation>
  </message>
  <message>
   <source>The point that decides, counted from 1</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>起决定作用的点，从 1 计数</translation>
  </message>
  <message>
   <source>Largest distance of its points to the projection, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>其点到投影的最大距离，px</translation>
  </message>
  <message>
   <source>The smallest tau of the slider at which it passes, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>滑块上使其通过的最小 tau，px</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>相机错误</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>标注错误</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>当前相机在本帧有误</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>本帧的点击有误</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>本帧的相机和点击均正确</translation>
  </message>
  <message>
   <source>What causes the score of this frame; saved with the dataset</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>本帧得分的错误归属；随数据集保存</translation>
  </message>
  <message>
   <source>Precision</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>精确率</translation>
  </message>
  <message>
   <source>Recall</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>召回率</translation>
  </message>
  <message>
   <source>Mean error</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>平均误差</translation>
  </message>
  <message>
   <source>Mean reprojection error of all points, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>所有点的平均重投影误差，px</translation>
  </message>
  <message>
   <source>Median reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>重投影误差中位数，px</translation>
  </message>
  <message>
   <source>Max</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>Largest reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>最大重投影误差，px</translation>
  </message>
  <message>
   <source>{name} has no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{name} 没有本帧的相机。</translation>
  </message>
  <message>
   <source>points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>点：{kinds}</translation>
  </message>
  <message>
   <source>{verdict}; once more takes it back ({key})</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{verdict}；再按一次撤回（{key}）</translation>
  </message>
  <message>
   <source>Verdict: {verdict}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>判定：{verdict}</translation>
  </message>
  <message>
   <source>Scores by element</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>各元素得分</translation>
  </message>
  <message>
   <source>Copy this explanation</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>复制此说明</translation>
  </message>
  <message>
   <source>Copy all explanations</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>复制所有说明</translation>
  </message>
  <message>
   <source>JaC –: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC –：{why}。</translation>
  </message>
  <message>
   <source>This frame's camera cannot be used:
{error}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>本帧的相机无法使用：
{error}</translation>
  </message>
  <message>
   <source>No fit to judge: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>没有可评判的拟合：{why}。</translation>
  </message>
  <message>
   <source>Counts as {class_name}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>计为 {class_name}</translation>
  </message>
  <message>
   <source>Verdict</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>判定</translation>
  </message>
  <message>
   <source>Elements whose points all are closer than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>所有点都比 tau 更近的元素</translation>
  </message>
  <message>
   <source>Elements too far, or projected and not annotated</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>过远的元素，或已投影但未标注的元素</translation>
  </message>
  <message>
   <source>Annotated elements that the camera does not project</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>已标注但相机未投影的元素</translation>
  </message>
  <message>
   <source>anchor</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>锚帧</translation>
  </message>
  <message>
   <source>followed</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>已跟踪</translation>
  </message>
  <message>
   <source>bridged</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>已衔接</translation>
  </message>
  <message>
   <source>lost</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>丢失</translation>
  </message>
  <message>
   <source>frame {number} of {first}–{last}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>第 {number} 帧，范围 {first}–{last}</translation>
  </message>
  <message>
   <source>{state}, {share:.0%} of the lines on paint</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{state}，{share:.0%} 的线落在画线上</translation>
  </message>
  <message>
   <source>names count by {step}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>名称以 {step} 递增</translation>
  </message>
  <message>
   <source>its camera was dragged</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>其相机已被拖动</translation>
  </message>
  <message>
   <source>blind: its camera is hidden</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>盲标：其相机已隐藏</translation>
  </message>
  <message>
   <source>{found}, {far:.1f} px from it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{found}，相距 {far:.1f} px</translation>
  </message>
  <message>
   <source>doubtful: {why}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>存疑：{why}</translation>
  </message>
  <message>
   <source>Frames of the shot</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>镜头的帧</translation>
  </message>
  <message>
   <source>The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>方向键逐帧移动，加 Shift 标记区段，Esc 取消标记</translation>
  </message>
  <message>
   <source>not {number:g}: {least:g} to {most:g}{unit}</source>
   <extracomment>[procc_annotator/gui/panels/widgets.py]</extracomment>
   <translation>不接受 {number:g}：{least:g} 到 {most:g}{unit}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>拟合与虚影</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>标注</translation>
  </message>
  <message>
   <source>blind: the camera is hidden until this frame is committed (Ctrl+Enter)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>盲标：提交本帧之前隐藏相机（Ctrl+回车）</translation>
  </message>
  <message>
   <source>load cameras first: there is nothing to score</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>请先加载相机：没有可评分的内容</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>请先打开图片文件夹</translation>
  </message>
  <message>
   <source>choose the camera to judge first (C)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>请先选择要评判的相机（C）</translation>
  </message>
  <message>
   <source>the live fit is off (Ctrl+T)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>实时拟合已关闭（Ctrl+T）</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>{text}。</translation>
  </message>
  <message>
   <source>unexpected error ({what})</source>
   <extracomment>[procc_annotator/gui/state/background.py]</extracomment>
   <translation>意外错误（{what}）</translation>
  </message>
  <message>
   <source>expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>应为 camera_00037.json、00037.npy 或 00037.homographyMatrix 之类的文件</translation>
  </message>
  <message>
   <source>load one of its folders: {names}</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>请加载其中一个文件夹：{names}</translation>
  </message>
  <message>
   <source>it holds the same already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>已含相同内容</translation>
  </message>
  <message>
   <source>it is annotated already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>已标注</translation>
  </message>
  <message>
   <source>{who} is editing it</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>{who} 正在编辑</translation>
  </message>
  <message>
   <source>it cannot be edited</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>无法编辑</translation>
  </message>
  <message>
   <source>blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked after that is no blind work</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>盲标：此处没有标注；再按 Ctrl+回车会显示相机，此后的点击不算盲标</translation>
  </message>
  <message>
   <source>{frame} is done</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} 已完成</translation>
  </message>
  <message>
   <source>nothing to undo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>本帧没有可撤销的内容</translation>
  </message>
  <message>
   <source>undo once more takes that away</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>再次撤销即可去除</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere and read again: {so}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} 已在别处更改并重新读取：{so}</translation>
  </message>
  <message>
   <source>unconfirmed elements do not count: {count}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>未确认的元素不计入：{count}</translation>
  </message>
  <message>
   <source>undone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>已撤销：{step}</translation>
  </message>
  <message>
   <source>redone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>已重做：{step}</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} 已在别处更改：已重新读取</translation>
  </message>
  <message>
   <source>nothing is undone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>没有撤销任何内容</translation>
  </message>
  <message>
   <source>nothing is redone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>没有重做任何内容</translation>
  </message>
  <message>
   <source>nothing to redo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>本帧没有可重做的内容</translation>
  </message>
  <message>
   <source>cameras of {name} changed: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>{name} 的相机已更改：{why}</translation>
  </message>
  <message>
   <source>cameras of {name} changed on disk: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>{name} 的相机在磁盘上已更改：已重新读取</translation>
  </message>
  <message>
   <source>not saved: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/saving.py]</extracomment>
   <translation>未保存：{why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks stay as they were: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>数据集的地标保持不变：{why}</translation>
  </message>
  <message>
   <source>{title} is at {place} m, ± {deviations}, from {views} views</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} 位于 {place} m，± {deviations}，由 {views} 个视图得出</translation>
  </message>
  <message>
   <source>{title} was deleted meanwhile: its place was not kept</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} 已被删除：其位置未保留</translation>
  </message>
  <message>
   <source>left out: {names}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>已排除：{names}</translation>
  </message>
  <message>
   <source>the dataset's landmarks are not used: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>数据集的地标未使用：{why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks can be used again</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>数据集的地标可再次使用</translation>
  </message>
  <message>
   <source>{names} share only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} 只提供元素的显示位置，没有相机：无地面可比较。</translation>
  </message>
  <message>
   <source>{names}: no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names}：本帧无相机。</translation>
  </message>
  <message>
   <source>{name} shares only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{name} 只提供元素的显示位置，没有相机：无地面可比较。</translation>
  </message>
  <message>
   <source>{a} and {b}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{a} 和 {b}</translation>
  </message>
  <message>
   <source>The two see no part of the field in common in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>两者在本帧中没有共同可见的场地部分。</translation>
  </message>
  <message>
   <source>Both cameras are the same in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>两个相机在本帧中相同。</translation>
  </message>
  <message>
   <source>No source is judged: choose one first.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>未评判任何源：请先选择一个。</translation>
  </message>
  <message>
   <source>Two sources of cameras are needed: load another one.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>需要两个相机源：请再加载一个。</translation>
  </message>
  <message>
   <source>The fitted camera sees no part of the field.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>拟合相机看不到场地的任何部分。</translation>
  </message>
  <message>
   <source>There is no fit of this frame, so no uncertainty map.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>本帧没有拟合，因此没有不确定度图。</translation>
  </message>
  <message>
   <source>No camera yet, so no uncertainty map: {why}.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>尚无相机，因此没有不确定度图：{why}。</translation>
  </message>
  <message>
   <source>the painted width cannot be drawn: {why}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>无法绘制画线宽度：{why}</translation>
  </message>
  <message>
   <source>{file} says what the field of this dataset is: to choose another one, move that file away and open the dataset again</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>{file} 指定了此数据集的场地：要选择其他场地，请移走该文件并重新打开数据集</translation>
  </message>
  <message>
   <source>field: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>场地：{field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>此数据集从现在起的场地：{field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on, {reach}: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>此数据集从现在起的场地，{reach}：{field}</translation>
  </message>
  <message>
   <source>no other field knows the classes here better</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>没有其他场地更符合这里的类别</translation>
  </message>
  <message>
   <source>{folder} cannot be written: what is annotated here has to be saved elsewhere (File &gt; Save copies to…)</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>无法写入 {folder}：此处的标注须保存到别处（文件 &gt; 副本保存到…）</translation>
  </message>
  <message>
   <source>not everything is saved yet: the other dataset was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>尚未全部保存：未打开另一个数据集</translation>
  </message>
  <message>
   <source>not everything is saved yet: the video was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>尚未全部保存：未打开视频</translation>
  </message>
  <message>
   <source>nothing is open</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>未打开任何内容</translation>
  </message>
  <message>
   <source>unfinished elements were kept: {titles}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>已保留未完成的元素：{titles}</translation>
  </message>
  <message>
   <source>the field of this dataset: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>此数据集的场地：{field}</translation>
  </message>
  <message>
   <source>the filter shows no further frame this way</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>此方向没有更多符合筛选的帧</translation>
  </message>
  <message>
   <source>you rejected it (Ctrl+Z takes that back)</source>
   <extracomment>[procc_annotator/gui/state/prediction/camera_choice.py]</extracomment>
   <translation>您已拒绝（Ctrl+Z 撤销）</translation>
  </message>
  <message>
   <source>draw 3 elements, two of which meet, such as {names}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>绘制 3 个元素（其中两个相交），例如 {names}</translation>
  </message>
  <message>
   <source>{title}: its line could not be looked for: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>{title}：无法寻找其线：{why}</translation>
  </message>
  <message>
   <source>chosen automatically</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>自动选择</translation>
  </message>
  <message>
   <source>H: homography of the ground</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>H：地面的单应矩阵</translation>
  </message>
  <message>
   <source>P: pinhole</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>P：针孔</translation>
  </message>
  <message>
   <source>R: pinhole, lens distortion</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R：针孔，镜头畸变</translation>
  </message>
  <message>
   <source>R+: R, aspect ratio, principal point</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R+：R，像素宽高比，主点</translation>
  </message>
  <message>
   <source>R2: R+, second radial coefficient</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R2：R+，第二径向系数</translation>
  </message>
  <message>
   <source>F: fisheye</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>F：鱼眼</translation>
  </message>
  <message>
   <source>the fit failed: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py]</extracomment>
   <translation>拟合失败：{why}</translation>
  </message>
  <message>
   <source>{who} unlocked this dataset from blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} 于 {day} 解除了此数据集的盲标模式</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} 原为“{status}”，现恢复为进行中</translation>
  </message>
  <message>
   <source>for you alone: the dataset's folder cannot be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>仅对您有效：无法写入数据集的文件夹</translation>
  </message>
  <message>
   <source>{reason}: there is no live fit in it</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}：其中没有实时拟合</translation>
  </message>
  <message>
   <source>This dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>此数据集已锁定为盲标模式</translation>
  </message>
  <message>
   <source>Somebody</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>某人</translation>
  </message>
  <message>
   <source>{who} locked this dataset to blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} 于 {day} 将此数据集锁定为盲标模式</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again: edited after the cameras were shown, it is no blind work any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} 原为“{status}”，现恢复为进行中：在显示相机之后编辑，不再算盲标</translation>
  </message>
  <message>
   <source>in this window only: nothing can be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>仅在此窗口中：无法写入任何内容</translation>
  </message>
  <message>
   <source>this dataset is not locked to blind mode any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>此数据集不再锁定为盲标模式</translation>
  </message>
  <message>
   <source>{reason}: menu Frame unlocks it, which is recorded</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}：可在“帧”菜单中解锁，并会记录</translation>
  </message>
  <message>
   <source>this dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>此数据集已锁定为盲标模式</translation>
  </message>
  <message>
   <source>{path}: no camera has the name of a frame (cameras are named like {camera!r}, frames like {frame!r})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}：没有相机与帧同名（相机名如 {camera!r}，帧名如 {frame!r}）</translation>
  </message>
  <message>
   <source>{path}: no cameras in it ({what_to_do})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}：其中没有相机（{what_to_do}）</translation>
  </message>
  <message numerus="yes">
   <source>no class of this field: {n} labels ({names})</source>
   <extracomment>no class of this field: {n} label ({names}) / no class of this field: {n} labels ({names}) [procc_annotator/gui/state/second.py]</extracomment>
   <translation>
    <numerusform>不是此场地的类别：{n} 个标签（{names}）</numerusform>
   </translation>
  </message>
  <message>
   <source>{path}: holds no annotation (*.json)</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>{path}：不含标注 (*.json)</translation>
  </message>
  <message>
   <source>second annotator: {why}</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>第二位标注者：{why}</translation>
  </message>
  <message>
   <source>{who} is editing it; it opens by itself once they leave it</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} 正在编辑；对方离开后会自动打开</translation>
  </message>
  <message>
   <source>nothing annotated yet</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>尚未标注任何内容</translation>
  </message>
  <message>
   <source>{who} on {machine}</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{machine} 上的 {who}</translation>
  </message>
  <message>
   <source>annotation cannot be read</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>标注无法读取</translation>
  </message>
  <message>
   <source>Enter runs it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>回车执行 · ↑ ↓ 选择 · Esc 关闭</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>面板</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>设置</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>打开</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>操作、元素、帧、相机源、文件夹、数字</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>查找任何内容</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>没有名为“{text}”的内容。</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>阈值 {px:g} px</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>第 {number} 帧，共 {count} 帧</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>前往此帧</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>用此 tau 评判元素</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>匹配项</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>评判 {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>用此源评判</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>实时拟合：模型 {model}</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>面板 {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>打开此面板并置于最前</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>开</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>关</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action guide]</extracomment>
   <translation>用户指南</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>在本页查找</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>用户指南为英文。</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>此安装未附带用户指南</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>关于 ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
用 ProCC 协议标注并审核体育相机标定。</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>标题</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>未加载相机（Ctrl+L）</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>请加载第二组相机以并排查看（Ctrl+L）</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>请加载第二组相机以进行比较（Ctrl+L）</translation>
  </message>
  <message>
   <source>Brightness</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>亮度</translation>
  </message>
  <message>
   <source>Contrast</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>对比度</translation>
  </message>
  <message>
   <source>Gamma</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>伽马</translation>
  </message>
  <message>
   <source>Bring out worn and shaded lines</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>突出磨损和阴影中的线</translation>
  </message>
  <message>
   <source>Only what you see changes, never the file</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>只改变您所看到的，绝不改变文件</translation>
  </message>
  <message>
   <source>Reset</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>重置</translation>
  </message>
  <message>
   <source>Shift all values</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>整体平移数值</translation>
  </message>
  <message>
   <source>Stretch values about middle grey</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>围绕中灰拉伸数值</translation>
  </message>
  <message>
   <source>To the right, dark parts become lighter</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>向右则暗处变亮</translation>
  </message>
  <message>
   <source>Line enhance</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>线条增强</translation>
  </message>
  <message>
   <source>Show the picture as it is</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>按原样显示图片</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>自定义按键</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>按键 (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}：{action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>搜索：词或按键。点击某行即执行。</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>在图片中</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>没有含“{text}”的按键、操作或元素。</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>搜索：词或按键</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>选择一行，然后按下其按键</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{one} 或 {other}</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, the action keys]</extracomment>
   <translation>按键</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>更改按键</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>仅这些</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>无按键</translation>
  </message>
  <message>
   <source>Default keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>默认按键</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>导入…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ 对应两个操作的按键都不起作用：请为其中之一设置其他按键。</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>导出按键</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>导入按键</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>新按键：在此按下</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>搜索按键</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>搜索</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>一次设置所有按键</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{file}：{error}；按键保持不变</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>操作或元素</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ 还有：{what}</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>更改类别为（与已标注的互换）</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>正在绘制 {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>在此分割：其余部分变为</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} 的虚影</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>接受</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>近看</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/menus.py, the action not_visible]</extracomment>
   <translation>此处不可见</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}：{step}</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} 的点 {number}</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>此处不可见：撤回</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>合并到</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title}，未确认</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>地面 ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>unexpected error ({what}); saving goes on, the details are in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>意外错误（{what}）；保存照常进行，详细信息在 {path}</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>光标的图片像素坐标；左上角像素的中心为 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>光标在场地地面上的位置，以距中心的米数表示</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>当前相机与对比相机看光标处的差距：
地面上的距离，以及评测尺寸的像素</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>拟合相机对光标处地面点的确定程度：
最差方向的标准差，不计光标本身的偏差</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>评分 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>“相机 &gt; 停止为数据集评分”可结束</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>比较 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>虚影 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Esc 结束</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>本帧不可编辑。{problem}</translation>
  </message>
  <message>
   <source>the details are copied; they are in {path}, too</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>详细信息已复制；也在 {path}</translation>
  </message>
  <message>
   <source>there was no unexpected error; they are logged in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>没有发生意外错误；错误记录在 {path}</translation>
  </message>
  <message>
   <source>not editable: the bar over the picture says why</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>不可编辑：图片上方的提示栏说明了原因</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>图片
亮度、对比度、伽马、线条增强：只改变您所看到的</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>工具栏</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>本帧在 tau 下的 Jaccard 指数</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>阈值 tau：元素的所有点都更近时即通过（+ 和 -）</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>被评判的相机集（按 C 切换）</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>本帧的状态（“审核”面板）</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>得分的计算条件：{terms}</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>已保存 {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>
    <numerusform>未保存：{n} 帧</numerusform>
   </translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>场地：{field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>点击以选择其他</translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>正在保存...</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>阈值 tau</translation>
  </message>
  <message>
   <source>JaC {jac:.3f} of the fit</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>拟合的 JaC {jac:.3f}</translation>
  </message>
  <message>
   <source>blind: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>盲标：提交后可见 JaC</translation>
  </message>
  <message>
   <source>{n} of {total}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>{n} / {total}</translation>
  </message>
  <message>
   <source>The camera is found without a click; dashed: what it expects. Shift+Enter accepts that</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>无需点击即可找到相机；虚线是其预期位置。按 Shift+Enter 接受</translation>
  </message>
  <message>
   <source>W switches to editing: drag a point off its line</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>按 W 切换到编辑：将一个点拖离其线</translation>
  </message>
  <message>
   <source>The tab Check lists possible mistakes: open it. F12 applies the first remedy</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>“检查”标签页列出可能的错误：请打开。F12 执行首选修复</translation>
  </message>
  <message>
   <source>Ctrl+Enter: this frame is done</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Enter：本帧完成</translation>
  </message>
  <message>
   <source>Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press Enter, choose its name</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Shift+D：无标注的帧。按 W 绘制一条线：点击两端，按 Enter，选择名称</translation>
  </message>
  <message>
   <source>Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your annotation</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>右上角“评判”（Shift+F2），再按 C：用您的标注评判拟合的相机</translation>
  </message>
  <message>
   <source>File &gt; Export as… writes the annotations for other programs: look at it</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>文件 &gt; 导出为… 为其他程序写出标注：请查看</translation>
  </message>
  <message>
   <source>That was the tour. Shift+F1: back to annotating; F1: all keys</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>导览结束。Shift+F1：返回标注；F1：所有按键</translation>
  </message>
  <message>
   <source>Go on to the next step</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>进入下一步</translation>
  </message>
  <message>
   <source>Esc ends the tour, too</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>按 Esc 也可结束导览</translation>
  </message>
  <message>
   <source>Skip</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>跳过</translation>
  </message>
  <message>
   <source>End</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>结束</translation>
  </message>
  <message>
   <source>the sample cannot be copied: {why}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>无法复制示例：{why}</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>将图片文件夹拖放到此处</translation>
  </message>
  <message>
   <source>Annotations are read from and saved as JSON next to the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>标注以 JSON 形式读取并保存在图片旁。之后拖入相机文件夹，即可用您的点击评判它们。</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>打开最近的</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>打开文件夹…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>打开图片…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>打开视频…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>试用示例</translation>
  </message>
  <message>
   <source>Tour (60 seconds)</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action tour]</extracomment>
   <translation>导览（60 秒）</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>继续</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>尚未打开任何内容</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>{setting}：恢复为 {value}</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>没有含“{text}”的设置。</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>设置</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>搜索设置</translation>
  </message>
  <message>
   <source>Reset all</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>全部重置</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>未指定</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py, the action keymap]</extracomment>
   <translation>更改按键…</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>得分</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>拟合</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>检查</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py, the action plots]</extracomment>
   <translation>图表</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>审核</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>一致性</translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>标注</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>评判</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>审核</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[procc_annotator/interaction/camera_view.py, the action disagreement]</extracomment>
   <translation>分歧</translation>
  </message>
  <message>
   <source>Uncertainty</source>
   <extracomment>[procc_annotator/interaction/camera_view.py]</extracomment>
   <translation>不确定度</translation>
  </message>
  <message numerus="yes">
   <source>{n} to go</source>
   <extracomment>{n} to go / {n} to go [procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>
    <numerusform>还差 {n} 个</numerusform>
   </translation>
  </message>
  <message>
   <source>choose an element first: field map, list, or its key</source>
   <extracomment>[procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>请先选择元素：场地图、列表或其按键</translation>
  </message>
  <message>
   <source>{title} is pinned, so that a slip does not move it: drag its points, or unpin elements (Ctrl+P, menu Element) to drag it as a whole</source>
   <extracomment>[procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>{title} 已固定，以防误动：请拖动其点，或取消固定元素（Ctrl+P，“元素”菜单）后整体拖动</translation>
  </message>
  <message numerus="yes">
   <source>move {n} points</source>
   <extracomment>move {n} point / move {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>移动 {n} 个点</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>delete {n} points</source>
   <extracomment>delete {n} point / delete {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>删除 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>draw {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>绘制 {title}</translation>
  </message>
  <message>
   <source>continue {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>继续 {title}</translation>
  </message>
  <message>
   <source>confirm {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>确认 {title}</translation>
  </message>
  <message>
   <source>move {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>移动 {title}</translation>
  </message>
  <message>
   <source>move all of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>整体移动 {title}</translation>
  </message>
  <message>
   <source>nudge {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>微移 {title}</translation>
  </message>
  <message>
   <source>insert a point in {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>在 {title} 中插入点</translation>
  </message>
  <message>
   <source>delete {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>删除 {title}</translation>
  </message>
  <message>
   <source>delete point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>删除 {title} 的第 {number} 点</translation>
  </message>
  <message numerus="yes">
   <source>nudge {n} points</source>
   <extracomment>nudge {n} point / nudge {n} points [procc_annotator/interaction/gestures.py]</extracomment>
   <translation>
    <numerusform>微移 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>click to draw; choose its class afterwards</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击绘制；之后选择类别</translation>
  </message>
  <message>
   <source>Backspace removes the last point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>退格移除最后一点</translation>
  </message>
  <message>
   <source>click marks it and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击标记它并进入 {title}</translation>
  </message>
  <message>
   <source>release drops it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>松开即放在此处</translation>
  </message>
  <message>
   <source>click or drag a point, drag elsewhere to select several</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击或拖动点；在别处拖动可选择多个</translation>
  </message>
  <message>
   <source>arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>方向键微移 {step:g} px，加 Shift {fine:g} px，加 Ctrl {far:g} px</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here, or open one with Ctrl+O</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>将图片文件夹拖放到此处，或用 Ctrl+O 打开</translation>
  </message>
  <message>
   <source>Ctrl+Enter commits the frame and shows the projection</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ctrl+回车提交本帧并显示投影</translation>
  </message>
  <message>
   <source>GHOST {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>虚影 {title}</translation>
  </message>
  <message>
   <source>GHOST the next one comes in a moment</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>虚影：下一个马上就来</translation>
  </message>
  <message numerus="yes">
   <source>Tab: next of {n} ghosts</source>
   <extracomment>Tab: next of {n} ghost / Tab: next of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab：{n} 个虚影中的下一个</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Tab: first of {n} ghosts</source>
   <extracomment>Tab: first of {n} ghost / Tab: first of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab：{n} 个虚影中的第一个</numerusform>
   </translation>
  </message>
  <message>
   <source>Shift+Enter: accept all</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Shift+回车：全部接受</translation>
  </message>
  <message>
   <source>Enter accepts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车接受</translation>
  </message>
  <message>
   <source>Tab goes on</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Tab 继续</translation>
  </message>
  <message>
   <source>. not visible here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>. 此处不可见</translation>
  </message>
  <message>
   <source>Esc goes back</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 返回</translation>
  </message>
  <message>
   <source>/ finds an element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>/ 查找元素</translation>
  </message>
  <message>
   <source>DRAW</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>绘制</translation>
  </message>
  <message>
   <source>choose an element: field map, list, its key or /</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>选择元素：场地图、列表、其按键或 /</translation>
  </message>
  <message numerus="yes">
   <source>DRAW a line, {n} points</source>
   <extracomment>DRAW a line, {n} point / DRAW a line, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>绘制一条线，{n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes, then choose the class</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车或双击完成，然后选择类别</translation>
  </message>
  <message numerus="yes">
   <source>DRAW {title}, {n} points</source>
   <extracomment>DRAW {title}, {n} point / DRAW {title}, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>绘制 {title}，{n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车或双击完成</translation>
  </message>
  <message>
   <source>click adds the second point and finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击添加第二点并完成</translation>
  </message>
  <message>
   <source>click adds a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击添加点</translation>
  </message>
  <message>
   <source>DRAW {title}, unconfirmed</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>绘制 {title}，未确认</translation>
  </message>
  <message>
   <source>DRAW {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>绘制 {title}</translation>
  </message>
  <message>
   <source>Enter confirms it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车确认</translation>
  </message>
  <message>
   <source>choose it again, then clicks continue it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>再次选择它，点击就会继续它</translation>
  </message>
  <message numerus="yes">
   <source>click continues it after its {n} points</source>
   <extracomment>click continues it after its {n} point / click continues it after its {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>点击在其 {n} 个点之后继续</numerusform>
   </translation>
  </message>
  <message>
   <source>click starts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击开始</translation>
  </message>
  <message>
   <source>click moves it here and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击将其移到此处并进入 {title}</translation>
  </message>
  <message>
   <source>Enter confirms {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车确认 {title}</translation>
  </message>
  <message numerus="yes">
   <source>Esc deselects {n} points</source>
   <extracomment>Esc deselects the point / Esc deselects {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Esc 取消选择 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>EDIT</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>编辑</translation>
  </message>
  <message>
   <source>release selects all points inside</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>松开选择其中所有的点</translation>
  </message>
  <message>
   <source>EDIT point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>编辑 {title} 的第 {number} 点</translation>
  </message>
  <message>
   <source>release selects the element, which is pinned</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>松开选择该元素，它已固定</translation>
  </message>
  <message>
   <source>EDIT the element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>编辑该元素</translation>
  </message>
  <message>
   <source>drag moves point {number} of {title}, Alt+Shift+click removes it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>拖动移动 {title} 的第 {number} 点，Alt+Shift+点击移除</translation>
  </message>
  <message>
   <source>click selects {title}, Alt+click inserts a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击选择 {title}，Alt+点击插入点</translation>
  </message>
  <message>
   <source>click does nothing: there are no points to edit, draw an element first</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击不起作用：没有可编辑的点，请先绘制元素</translation>
  </message>
  <message>
   <source>click a point to drag it, elsewhere to deselect</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击点以拖动，点击别处取消选择</translation>
  </message>
  <message numerus="yes">
   <source>Delete removes {n} points</source>
   <extracomment>Delete removes the point / Delete removes {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Delete 移除 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>click draws it by hand</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击手动绘制</translation>
  </message>
  <message numerus="yes">
   <source>Enter accepts {n} points</source>
   <extracomment>Enter accepts {n} point / Enter accepts {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>回车接受 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>no line found along it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>沿线未找到线</translation>
  </message>
  <message>
   <source>an element's key names it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>元素的按键为其命名</translation>
  </message>
  <message>
   <source>Enter or double-click finishes and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>回车或双击完成并进入 {title}</translation>
  </message>
  <message>
   <source>Esc cancels</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 取消</translation>
  </message>
  <message>
   <source>Esc deselects</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 取消选择</translation>
  </message>
  <message>
   <source>click moves it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击将其移到此处</translation>
  </message>
  <message>
   <source>click marks it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点击标记它</translation>
  </message>
  <message>
   <source>hold Ctrl: no snapping</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>按住 Ctrl：不吸附</translation>
  </message>
  <message>
   <source>Delete removes {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Delete 移除 {title}</translation>
  </message>
  <message>
   <source>EDIT choosing points</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>编辑：选择点</translation>
  </message>
  <message numerus="yes">
   <source>EDIT {n} points</source>
   <extracomment>EDIT {n} point / EDIT {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>编辑 {n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>READ ONLY</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>只读</translation>
  </message>
  <message>
   <source>BLIND</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>盲标</translation>
  </message>
  <message>
   <source>Shift+Enter finishes and stays</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Shift+回车完成并停留</translation>
  </message>
  <message>
   <source>Esc removes the new point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 移除新点</translation>
  </message>
  <message>
   <source>Esc lets go</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc 放开</translation>
  </message>
  <message>
   <source>passes</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>通过</translation>
  </message>
  <message>
   <source>too far</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>过远</translation>
  </message>
  <message>
   <source>annotated, not projected</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>已标注，未投影</translation>
  </message>
  <message>
   <source>projected, not annotated</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>已投影，未标注</translation>
  </message>
  <message>
   <source>ghost of an unsure camera</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>存疑相机的虚影</translation>
  </message>
  <message>
   <source>ghost: expected here</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>虚影：预期在此</translation>
  </message>
  <message>
   <source>annotated, in its class's colour</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>已标注，以其类别的颜色</translation>
  </message>
  <message>
   <source>to be confirmed</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>待确认</translation>
  </message>
  <message>
   <source>projection</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>投影</translation>
  </message>
  <message>
   <source>second annotator</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>第二位标注者</translation>
  </message>
  <message>
   <source>no distance</source>
   <extracomment>[procc_annotator/interaction/overlay_primitives.py]</extracomment>
   <translation>无距离</translation>
  </message>
  <message>
   <source>not annotated</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>未标注</translation>
  </message>
  <message>
   <source>missed</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>未命中</translation>
  </message>
  <message>
   <source>{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 吻合：最远的第 {number} 点偏离 {px} px；tau &gt; {px} 时通过。</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 过远：第 {number} 点偏离 {px} px；tau &gt; {px} 时通过。</translation>
  </message>
  <message>
   <source>{title} (judged as {other}, labels mirrored)</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{title}（按 {other} 评判，类别镜像）</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the camera does not show it in the picture.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 未命中：已标注，但相机未在图片中显示它。</translation>
  </message>
  <message>
   <source>{element} is not annotated, but the camera shows it: a false positive.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 未标注，但相机显示了它：假阳性。</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} has no distance, because the projection has coinciding samples there; it passes at no tau.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 过远：第 {number} 点没有距离，因为投影在该处有重合的采样点；任何 tau 都不通过。</translation>
  </message>
  <message>
   <source>As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what is in the picture alone.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>若延续到图片之外，最多偏离 {px} px，但 soccernet 只测量到图片内的部分。</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the field has no such element to project.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 未命中：已标注，但场地没有可投影的此元素。</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but it leaves the ground, and the camera knows only the ground.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} 未命中：已标注，但它离开地面，而相机只知道地面。</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>标注文件夹中的所有图片</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>标注单张图片</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>直接标注视频的帧，无需先导出</translation>
  </message>
  <message>
   <source>Season…</source>
   <extracomment>[the action season]</extracomment>
   <translation>赛季…</translation>
  </message>
  <message>
   <source>List the matches of a season (a folder in which videos lie) to open one of them</source>
   <extracomment>[the action season]</extracomment>
   <translation>列出一个赛季（存放视频的文件夹）的比赛，以打开其中一场</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>打开示例</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>打开随程序附带的帧的个人副本</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>打开第二位标注者…</translation>
  </message>
  <message>
   <source>Draw and compare what another annotator clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>绘制并比较他人在相同帧上的点击</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>关闭第二位标注者</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>恢复为只显示本数据集的标注</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>从文件…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>您自己的描述：任何运动皆可，见用户指南</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>切换到匹配的场地</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>显示含有本帧所标类别的场地</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>重新读取文件</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>写入本数据集的场地文件时会自动进行</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>立即保存</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>每次完成的编辑都会立即保存；此操作重试失败的保存</translation>
  </message>
  <message>
   <source>Write what could not be saved in its own place to another folder</source>
   <extracomment>[the action save_copies]</extracomment>
   <translation>将无法保存到原位置的内容写入另一文件夹</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>导入标注…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>逐帧导入其他程序或数据集的标注</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>导出为…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>为其他程序写出标注：CVAT、labelme、COCO、SoccerNet、掩码</translation>
  </message>
  <message>
   <source>Export annotations as JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>将标注导出为 JSON…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of JSON files</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>将所有帧的标注写为 JSON 文件的文件夹或 zip</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>导出数据集的 JaC…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>将每帧的 JaC 写为 CSV 或 JSON</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>导出来源记录…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>将每个点如何产生、由谁产生写入附带的 JSON</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>保存叠加图片…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>将带标注、投影和图例的图片写为 PNG、JPEG 或 SVG</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>导出总览…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>将每帧的状态、数量和用时写为 CSV</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>导出判定…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>将每帧的错误归属、JaC 和最大误差写为 CSV</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>导出检查结果…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>将已检查帧的类别检查结果写为 CSV</translation>
  </message>
  <message>
   <source>Author name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>作者姓名…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>您的点、评论和版本所署的姓名</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>退出</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>关闭窗口；一切均已保存</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>撤销</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>撤回本帧的最后一步</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>重做</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>再次执行该步骤</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>删除点或元素</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>移除选中的点；若无，则移除选中的元素</translation>
  </message>
  <message>
   <source>Insert point</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>插入点</translation>
  </message>
  <message>
   <source>Put a point on the line at the crosshair, or at the mouse (Alt and a click do it, too)</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>在十字光标或鼠标处的线上放置点（Alt 加点击亦可）</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>选择所有点</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>选择所选元素或本帧的所有点</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>丢弃刚点击的点，然后取消选择</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>设置…</translation>
  </message>
  <message>
   <source>Theme, text size, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>主题、文字大小，以及窗口如何绘制、拟合和评判</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>用方向键</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>左移 1 px</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>将选中的点移动 1 px；若无选中的点，则移动十字光标</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>右移 1 px</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>上移 1 px</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>下移 1 px</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>左移 0.1 px</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>将选中的点移动 0.1 px；若无选中的点，则移动十字光标</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>右移 0.1 px</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>上移 0.1 px</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>下移 0.1 px</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>左移 10 px</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>将选中的点移动 10 px；若无选中的点，则移动十字光标</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>右移 10 px</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>上移 10 px</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>下移 10 px</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>左移 100 px</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>将选中的点移动 100 px；若无选中的点，则移动十字光标</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>右移 100 px</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>上移 100 px</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>下移 100 px</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>下一帧</translation>
  </message>
  <message>
   <source>Show the next picture, of those that the filter shows</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>在筛选所显示的图片中，显示下一张</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>上一帧</translation>
  </message>
  <message>
   <source>Show the previous picture, of those that the filter shows</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>在筛选所显示的图片中，显示上一张</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>下一个未完成</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>前往下一个既未完成也未批准的帧</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>上一个未完成</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>返回上一个既未完成也未批准的帧</translation>
  </message>
  <message>
   <source>Go to</source>
   <extracomment>[the menus]</extracomment>
   <translation>前往</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>下一个被退回</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>前往审核者退回的下一帧</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>下一个最差 JaC</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>JaC 最低的帧；再按一次：次低的帧</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>下一个最大误差</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>点误差最大的帧；再按一次：次大的帧</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>按分歧的下一帧</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>当前源与对比源在地面上相距最远的帧；再按一次：下一个</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>类别检查</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>下一个检查结果</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>逐帧前往类别检查发现的下一处</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>上一个检查结果</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>返回上一处检查结果</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>执行首选修复</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>修复当前检查结果：改类别、互换、移除坏点，或查看</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>下一个无标注</translation>
  </message>
  <message>
   <source>Go to the next frame without annotations</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>前往下一个没有标注的帧</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>上一个无标注</translation>
  </message>
  <message>
   <source>Go to the previous frame without annotations</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>返回上一个没有标注的帧</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>第一帧</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>显示第一张图片</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>最后一帧</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>显示最后一张图片</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>镜头</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>跟踪镜头</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>从本帧向两个方向求出该镜头所有帧的相机；再按一次停止</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>接受区段</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; annotated ones are left out, and doubtful ones unless it is pressed again</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>沿跟踪结果标注镜头或条带上所选区段的帧；已标注的帧略过，存疑的帧需再按一次才接受</translation>
  </message>
  <message>
   <source>Annotate all that is sure</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>标注所有确定的帧</translation>
  </message>
  <message>
   <source>Annotate every frame of the dataset whose camera is found and sure, in one step; Next doubtful frame (Alt+PgDown) then goes through the others, the least sure first</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>一步标注数据集中已找到相机且确定的所有帧；之后用“下一个存疑帧”（Alt+PgDown）逐个查看其余的帧，最不确定的在前</translation>
  </message>
  <message>
   <source>Take back what was accepted last</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>撤回最后接受的内容</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>最近接受且此后未编辑的帧恢复原状</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>前进十帧</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>向前跳十帧</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>后退十帧</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>向后跳十帧</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>下一个已标注帧</translation>
  </message>
  <message>
   <source>Go on to the next frame that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>前往下一个已标注的帧</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>上一个已标注帧</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>返回上一个已标注的帧</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>下一个存疑帧</translation>
  </message>
  <message>
   <source>Go to the next frame whose track should be checked</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>前往下一个需要查看跟踪的帧</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>上一个存疑帧</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>返回上一个存疑的帧</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>播放或暂停</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>依次显示各帧；再按一次或任何编辑即停止</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>查找帧…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>输入帧名的一部分</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>盲标模式</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>在提交本帧之前隐藏投影，以免相机影响点击</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>将数据集锁定为盲标模式</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>标注此数据集的所有人均为盲标模式；解锁需确认并会记录</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>完成</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>本帧已完成；盲标模式下会显示投影</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>审核者认为本帧正确</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>审核者退回本帧；请在评论中说明原因</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>恢复为进行中</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>本帧其实尚未完成</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>评论…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>在本帧的讨论中留言</translation>
  </message>
  <message>
   <source>Comment on this place…</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>评论此处…</translation>
  </message>
  <message>
   <source>Write a comment on the place at the cursor; a numbered pin marks it in the picture</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>对光标处写评论；带编号的图钉在图片中标出该处</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>早期版本…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>查看本帧所有保存的版本并恢复其中之一</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>视图分组…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>通过名称指明哪些帧是不同相机拍摄的同一瞬间</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>保留此视频帧</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture next to its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>将视频的这一帧写为标注旁的图片</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>从上一帧复制</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>沿用之前标注帧的元素，并随相机运动移动；等待确认</translation>
  </message>
  <message>
   <source>Confirm all unconfirmed elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>确认所有未确认的元素</translation>
  </message>
  <message>
   <source>Copied and unfinished elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>复制的和未完成的元素从现在起计入并保存</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>丢弃未确认的元素</translation>
  </message>
  <message>
   <source>Remove copied and unfinished elements that were not edited</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>移除未编辑过的复制元素和未完成元素</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>规整所有元素</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>沿画线对本帧每个元素重新取点</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>绘制</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>点击为所选元素添加点</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>拖动、插入和移除点</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>在绘制与编辑之间切换</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>从绘制到编辑，再返回</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>下一个元素</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>选择场地的下一个元素</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>上一个元素</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>选择上一个元素</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>查找元素…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>输入元素名的一部分</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>完成元素</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>将刚点击的点变成一个元素（或双击最后一点）</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>完成并停留</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>完成元素而不进入下一个</translation>
  </message>
  <message>
   <source>Remove the last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>移除最后一点</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>移除最后点击的点</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>删除元素</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>移除选中的元素及其所有点</translation>
  </message>
  <message>
   <source>Confirm element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>确认元素</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>选中的元素从现在起计入并保存（编辑时按回车）</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>规整</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>沿画线对元素重新取点：两次点击成直线，五次成曲线</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>闭合间隙</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>将元素的端点延伸到其未到达的角点或图片边缘</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>反向</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>反转元素的点的顺序</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>复制到对称类别</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>以旋转场地的类别放置一份副本，再拖到位</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>吸附到线</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click off it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>画线附近的点击会移到其中心（按住 Ctrl 可点在旁边）</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>进入下一个元素</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>完成一个元素后，选择最可能的下一个</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>两次点击完成直线元素</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>直线元素的第二次点击即完成它</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>先画后命名</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>未选元素时，点击即开始一条线；完成后在笔旁提供最可能的元素</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>固定元素</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>只能拖动点，不能拖动整个元素</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>虚影</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>下一个虚影</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>近看拟合相机预期的下一个元素</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>上一个虚影</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>近看上一个</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>接受虚影</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>将虚影变成元素：在其画线上取点，被遮挡处不取（回车）</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>接受所有虚影</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>接受画线足够清晰可见的所有虚影（未在绘制时按 Shift+回车）</translation>
  </message>
  <message>
   <source>Accept all and go on</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>全部接受并继续</translation>
  </message>
  <message>
   <source>Accept all ghosts of this frame and show the next one: one key a frame</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>接受本帧的所有虚影并显示下一帧：每帧一个按键</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>全部接受所需的可见度…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>虚影的画线要有多少可见，才能与其他一并接受</translation>
  </message>
  <message>
   <source>The ghost or the chosen element cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>该虚影或所选元素在本帧不可见；再按一次撤回</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>撤回“此处不可见”</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>最近标为在本帧不可见的元素可能仍然可见</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>显示虚影</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>在拟合相机预期但尚未标注的元素处绘制淡曲线</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>在图片中寻找相机</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>尚无标注时，无需点击即求出相机并以虚影显示其元素；接受之前不保存任何内容</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>提示下一步标注什么</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>在场地图上标出最能提高拟合相机可靠性的元素</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>适合窗口</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>显示整张图片</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>实际大小</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>一个图片像素对应一个屏幕像素</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>放大</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>放大（鼠标滚轮在光标处放大）</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>缩小</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>缩小（鼠标滚轮在光标处缩小）</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>平移</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>左键移动图片（或按住空格、中键）；Esc 结束</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>跨帧保持缩放</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>换帧时停留在图片的同一位置</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>隐藏叠加层</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>只显示图片（或按住 X）</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>着色依据</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>判据</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>颜色表示相机的评判结果</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>类别</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>每个元素使用各自的颜色</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>来源记录</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>按点的产生方式：点击、吸附、规整、复制、移动</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>标注者</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>按放置点的人</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>画线宽度</translation>
  </message>
  <message>
   <source>Draw how wide the field's lines must appear, along the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>在投影旁绘制场地画线应有的宽度</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>画线证据</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>每段旁有一条带：其下可见画线为实线，画线偏在一侧时该侧为虚线，无画线为点线</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>放大镜</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>将放大镜保持在光标处（或按住 Z；拖动点时也会出现）</translation>
  </message>
  <message>
   <source>Legend in the picture</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>图片中的图例</translation>
  </message>
  <message>
   <source>What the colours, dashes and marks over the picture mean, in its corner; it gives way to the hand</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>图片一角说明其上颜色、线型和标记的含义；手到之处自动让开</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>将场地图转向相机</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>场地图下方为相机所在一侧，相机看不到的部分变淡</translation>
  </message>
  <message>
   <source>Picture on the field map</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>在场地图上显示图片</translation>
  </message>
  <message>
   <source>Show the picture on the field map, as seen from above: lines that bend or miss the map's show where a camera is wrong</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>在场地图上显示俯视图片：弯曲或偏离地图的线条表明相机有误之处</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>帧条</translation>
  </message>
  <message>
   <source>Below the picture: thumbnails of the frames, or the timeline of a video</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>图片下方：各帧的缩略图，或视频的时间轴</translation>
  </message>
  <message>
   <source>List of frames</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>帧列表</translation>
  </message>
  <message>
   <source>Show the frames with their names and a filter at the left, instead of the strip; once more closes the list</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>在左侧显示带名称和筛选的帧，代替帧条；再按一次关闭列表</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>本帧或数据集的误差和 JaC，涵盖所有显示的源</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>标注面板</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>元素、检查结果、地标</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>评判面板</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>得分、相机源、拟合、图表</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>审核面板</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>状态、评论与用时、第二位标注者</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>隐藏所有面板</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>把全部空间留给图片</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>键盘转到面板</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>在图片中 Tab 遍历虚影；此操作将键盘转到面板</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>键盘转到下一部分</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>图片、面板、工具栏：键盘依次轮转</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>键盘转到上一部分</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>反方向轮转</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>重置布局</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>将面板放回最初的位置</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>加载相机…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>用标注评判一个文件夹的相机或单应矩阵</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>加载相机文件…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>评判单个相机文件或其 zip</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>下一个相机源</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>用已加载的下一个源评判</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>上一个相机源</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>用上一个源评判</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>与对比源互换</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>用对比源评判，并与当前源比较（或轻按逗号；按住则仅查看）</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>绘制其他源</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes, with the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>将相机面板中勾选的源以线框绘制在当前源旁</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>分割视图</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>分隔线左侧绘制当前源，右侧绘制对比源</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>当前源与对比源在地面上对每个像素相差多少米</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>不确定度图</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>拟合相机在场地何处精确到 0.1、0.5 和 1 m</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>实时拟合</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>每次编辑后根据本帧的点击拟合相机</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>将拟合保存为本帧的相机</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>将根据点击拟合的相机写入数据集的 cameras/fitted 文件夹</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>场地尺寸…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>此体育场场地的长和宽（输入或由所有帧求出），以及点击位于画线的何处</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>阈值增加 0.5 px</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>允许更大的距离</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>阈值减少 0.5 px</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>只允许更小的距离</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>SoccerNet 官方评测，包括其怪癖</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>论文的定义，不含官方代码的瑕疵</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>离地元素</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>计为未命中</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>单应矩阵无法投影的球门、篮筐和球网计为其失分</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>单应矩阵无法投影的球门、篮筐和球网不计入</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>相机错误</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>当前相机在本帧有误；再按一次撤回判定</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>标注错误</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>本帧的点击有误；再按一次撤回判定</translation>
  </message>
  <message>
   <source>OK</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>无误</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>本帧的相机和点击均正确；再按一次撤回判定</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>判定备注…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>用几个词说明错误所在；随判定一同导出</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>停止为数据集评分</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>停止计算尚未打开的帧的 JaC 并停止比较各源</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>查找任何内容…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>命令面板：用名称的几个字母找到任何操作、元素、帧、相机源和最近的文件夹</translation>
  </message>
  <message>
   <source>Draw, accept, check, judge and export, step by step, on a copy of the sample</source>
   <extracomment>[the action tour]</extracomment>
   <translation>在示例的副本上逐步绘制、接受、检查、评判并导出</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>在一张表上显示所有操作及其按键</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>为操作和元素设置其他按键，或采用其他程序的按键</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>随程序附带的指南；无需网络</translation>
  </message>
  <message>
   <source>Copy details of the last error</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>复制最近一次错误的详细信息</translation>
  </message>
  <message>
   <source>What an unexpected error left in the log, for a report to the maintainers</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>意外错误在日志中留下的内容，用于向维护者报告</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>版本</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>外观</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>主题</translation>
  </message>
  <message>
   <source>Light, dark or system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>浅色、深色或跟随系统</translation>
  </message>
  <message>
   <source>System</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>跟随系统</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>浅色</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>深色</translation>
  </message>
  <message>
   <source>Text size</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>文字大小</translation>
  </message>
  <message>
   <source>Text size, % of system (after restart)</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>文字大小，系统的 %（重启后）</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>语言</translation>
  </message>
  <message>
   <source>Language of the window (after restart); files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>窗口的语言（重启后）；文件保持不变</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>图片上颜色的含义</translation>
  </message>
  <message>
   <source>Author name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>作者姓名</translation>
  </message>
  <message>
   <source>Author name (empty = login name)</source>
   <extracomment>[the setting author]</extracomment>
   <translation>作者姓名（空 = 登录名）</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>评判</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>阈值</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>标注点与其元素的最大允许距离，以评测尺寸的 px 计</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>相机的评判方式：与官方评测相同（含怪癖），或按论文的定义</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc（论文）</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>单应矩阵无法投影的元素如何计入：球门、篮筐、球网</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>实时拟合的模型</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>根据点击拟合的相机；auto：点击所能支持的最简模型</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>评判拟合</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>没有其他源时是否评判拟合</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>全部接受所需的可见度</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>虚影的线要有多少可见，才能与其他所有一并接受</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>美式橄榄球（NFL）</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>近侧边线</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>远侧边线</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>近侧码标</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>远侧码标</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>左端线</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左球门线</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 5 码线</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 10 码线</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 15 码线</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 20 码线</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 25 码线</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 30 码线</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 35 码线</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 40 码线</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 45 码线</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>50 码线</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>右端线</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右球门线</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 5 码线</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 10 码线</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 15 码线</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 20 码线</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 25 码线</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 30 码线</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 35 码线</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 40 码线</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 45 码线</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左横梁</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左球门左立柱</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左球门右立柱</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右横梁</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右球门左立柱</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右球门右立柱</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左加分标记</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右加分标记</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>含两端区的长度</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>宽度</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>端区深度</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>码</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>码线到边线</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>码标到边线</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>加分标记到球门线</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>加分标记长度</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>球门宽度</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>横梁高度</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>横梁以上立柱</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>线宽</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>球门线宽度</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>边框宽度</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左半场</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右半场</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左球门</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右球门</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>田径（400 m 跑道）</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>内突沿</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>分道线 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>第 8 道外沿</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>第 9 道外沿</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>终点线</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>100 m 起点</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>110 m 栏起点</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>3000 m 和 5000 m 起点</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>10,000 m 起点</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>抢道线</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 1 道</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 2 道</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 3 道</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 4 道</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 5 道</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 6 道</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 7 道</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 8 道</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点，第 9 道</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 2 道</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 3 道</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 4 道</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 5 道</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 6 道</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 7 道</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 8 道</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点，第 9 道</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 2 道</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 3 道</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 4 道</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 5 道</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 6 道</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 7 道</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 8 道</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点，第 9 道</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道内侧线</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道线 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>八道长度</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>八道宽度</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>跑道宽度</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>跑道</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>终点与起点</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m 起点（组）</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m 起点（组）</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m 起点（组）</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直道</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>篮球（FIBA）</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右端线</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左端线</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>中线</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>中圈</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左限制区，远侧</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>左罚球线</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左限制区，近侧</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>左罚球半圆</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右限制区，远侧</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>右罚球线</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右限制区，近侧</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>右罚球半圆</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左三分弧线</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左三分线，远侧直段</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左三分线，近侧直段</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分弧线</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分线，远侧直段</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分线，近侧直段</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左篮板</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左篮圈</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>左合理冲撞半圆</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右篮板</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右篮圈</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>右合理冲撞半圆</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左篮板矩形框</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左篮圈中心</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右篮板矩形框</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右篮圈中心</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>长度</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>中线超出边线部分</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>圆半径</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>限制区长度</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>限制区宽度</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>三分线半径</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>三分线到边线</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>合理冲撞区半径</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板到端线</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板宽度</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板高度</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板下沿</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板矩形宽度</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮板矩形高度</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮圈高度</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮圈半径</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>篮圈到篮板</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>球场</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左限制区</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右限制区</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左三分线</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分线</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左篮筐</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右篮筐</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>篮球（NBA）</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左罚球圈</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右罚球圈</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左进攻合理区弧</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右进攻合理区弧</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>内中圈</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左远侧标线</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右远侧标线</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左近侧标线</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右近侧标线</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>内圈半径</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>进攻合理区半径</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>标线到端线</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>标线长度</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>五人制足球</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>近侧边线</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>远侧边线</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>中线</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>左罚球区线</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>右罚球区线</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>左球门，远柱</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>左球门，近柱</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右球门，远柱</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右球门，近柱</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>中点</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左罚球点</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>左第二罚球点</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右罚球点</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>右第二罚球点</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左远侧角球弧</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左近侧角球弧</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右远侧角球弧</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右近侧角球弧</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>远侧换人区，左外</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>远侧换人区，左内</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>远侧换人区，右内</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>远侧换人区，右外</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>近侧换人区，左外</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>近侧换人区，左内</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>近侧换人区，右内</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>近侧换人区，右外</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>门柱宽度</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>罚球区半径</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>罚球点到球门线</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>第二罚球点到球门线</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>中圈半径</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>角球弧半径</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>球门高度</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>球场</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左罚球区</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右罚球区</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>标记点</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>角</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>换人区</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>手球</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>近侧边线</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>远侧边线</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>开球区</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左球门区线</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左 7 米线</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左 4 米线</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右球门区线</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右 7 米线</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右 4 米线</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>远侧换人线，左</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>远侧换人线，右</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>近侧换人线，左</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>近侧换人线，右</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>球门区半径</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>任意球线半径</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>左球门区</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>右球门区</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>换人线</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>冰球（IIHF）</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近侧边板</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远侧边板</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左端板</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右端板</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近左角</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远左角</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近右角</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远右角</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左蓝线</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右蓝线</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近左争球圈</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远左争球圈</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近右争球圈</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远右争球圈</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左球门区</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>左球门，左柱</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>左球门，右柱</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右球门区</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右球门，左柱</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右球门，右柱</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左梯形区，近</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左梯形区，远</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右梯形区，近</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右梯形区，远</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近侧裁判区</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远侧裁判区</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>中点</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近左端争球点</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远左端争球点</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近右端争球点</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远右端争球点</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近左中区争球点</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远左中区争球点</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近右中区争球点</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远右中区争球点</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近侧边板上沿</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远侧边板上沿</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左端板上沿</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右端板上沿</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近左角上沿</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远左角上沿</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>近右角上沿</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>远右角上沿</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>角半径</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>界墙高度</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>球门线到端板</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>蓝线到端板</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>争球圈半径</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>端区争球点到球门线</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>中区争球点到蓝线</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>争球点到纵轴</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>球门区半径</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>球门区宽度</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>裁判区半径</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>梯形区（球门线处）</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>梯形区（端板处）</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>蓝线与中线宽度</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>界墙</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>线</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>争球圈</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>争球点</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>界墙上沿</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>冰球（NHL）</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>蓝线到球门线</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>足球</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球区，近侧线</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球区，前沿线</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球区，远侧线</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区，近侧线</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区，前沿线</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区，远侧线</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球弧</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球弧</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左球门区，近侧线</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左球门区，前沿线</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左球门区，远侧线</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区，近侧线</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区，前沿线</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区，远侧线</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左远侧角旗（底）</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左近侧角旗（底）</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右远侧角旗（底）</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右近侧角旗（底）</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>罚球区深度</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>罚球区宽度</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>球门区深度</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>球门区宽度</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>未知球门</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>未知线</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>网球</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左底线</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右底线</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>远侧双打边线</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>近侧双打边线</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>远侧单打边线</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>近侧单打边线</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左发球线</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右发球线</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>中发球线</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>球网上沿</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>远侧网柱</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>近侧网柱</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>球网中心带</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>远侧单打支柱</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>近侧单打支柱</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左中点标</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右中点标</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>单打宽度</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>发球线到球网</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>底线宽度</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>中线宽度</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>中点标长度</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>中心带处网高</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>网柱处网高</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>单打支柱处网高</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>网柱到边线</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>发球区</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>球网</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>排球</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左进攻线</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右进攻线</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>球网上沿带</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>球网下沿带</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>远侧标志杆</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>近侧标志杆</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>远侧网柱</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>近侧网柱</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左远侧延长线</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左近侧延长线</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右远侧延长线</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右近侧延长线</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左远侧发球区短线</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左近侧发球区短线</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右远侧发球区短线</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右近侧发球区短线</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>进攻线到中线</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>网高</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>网幅</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>网长</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>标志杆高出球网</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>网柱到边线</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>网柱高度</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>进攻线延长线</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>发球区短线到端线</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>发球区短线长度</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>场外标记</translation>
  </message>
 </context>
</TS>
