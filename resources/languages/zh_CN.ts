<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
 <context>
  <name>procc</name>
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
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/context_menu.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>帧</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>元素</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>视图</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/palette_entries.py, the menus]</extracomment>
   <translation>相机</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>帮助</translation>
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
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>无</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>滚轮</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>在光标处缩放</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>双指</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>平移；捏合则缩放</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Shift + 滚轮</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>横向平移，如同倾斜滚轮</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>空格 + 拖动</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>平移</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>中键</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>按住 X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>隐藏所有叠加层</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>按住 Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>放大镜：图片像素的八倍</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>按住 ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>查看对比的相机源</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>轻按 ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>用对比源评判，与当前源比较</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>按住 Ctrl</translation>
  </message>
  <message>
   <source>click beside the line: no snapping</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>点在线旁：不吸附</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + 拖动线</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>相机：随之移动，该处成为固定桩</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + 点击固定桩</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>相机：移除固定桩</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>方向键</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>十字光标：用键指点；若有选中的点则移动它们</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>十字光标处按空格</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>等同在该处点击（加 Ctrl：不吸附）</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>右键</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>光标下内容的菜单</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>回车</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>接受当前虚影</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Shift+回车</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>接受所有虚影</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>点击</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>绘制：添加点</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>双击</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>绘制：完成</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>拖动点</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：移动它</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Shift+点击点</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：选择多个</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>在空白处拖动</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：选择其中的点</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>拖动线</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：移动元素，除非元素已固定</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+点击线</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：插入点</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+Shift+点击</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>编辑：移除该点</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>在帧条上点击或拖动</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>前往某帧</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>帧条上滚轮</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>缩放；加 Shift 则滚动</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>帧条上 Shift+拖动</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>标记区段（双击取消）</translation>
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
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} 已存在，且内容不同。</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{text}。</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>删除 {what}？</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>删除</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>替换</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>保留</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} 帧未保存，刚才再次保存失败。</numerusform>
   </translation>
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
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>显示文件中的内容；撤销可恢复您的版本</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>用我的覆盖</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>将屏幕上的内容覆盖写入文件</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>本帧不可编辑。{problem}</translation>
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
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/settings.py, procc_annotator/gui/window/rail.py, the setting evidence]</extracomment>
   <translation>图片</translation>
  </message>
  <message>
   <source>no camera</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>无相机</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>本帧在 tau 下的 Jaccard 指数</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>被评判的相机集（按 C 切换）</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>得分的计算条件：{terms}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC –&lt;/b&gt; {why}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC –&lt;/b&gt; {why}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; of the fit</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>拟合的 &lt;b&gt;JaC {jac:.3f}&lt;/b&gt;</translation>
  </message>
  <message>
   <source>&lt;b&gt;blind&lt;/b&gt;: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;盲标&lt;/b&gt;：提交后可见 JaC</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>相机无法读取</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>此处无相机</translation>
  </message>
  <message>
   <source>Three steps to a frame</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>三步完成一帧</translation>
  </message>
  <message>
   <source>Click the two ends of a painted line, then Enter</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>点击一条画线的两端，然后按回车</translation>
  </message>
  <message>
   <source>{keys}: points along every line, on its paint</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}：沿每条线在画线上取点</translation>
  </message>
  <message>
   <source>{keys}, then Enter: take what the camera expects</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}，然后按回车：采用相机所预期的</translation>
  </message>
  <message>
   <source>Put the three steps away for ever (Help has the user guide)</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>永久收起三个步骤（用户指南在“帮助”中）</translation>
  </message>
  <message>
   <source>Put the three steps away</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>收起三个步骤</translation>
  </message>
  <message>
   <source>{step}, done</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{step}，已完成</translation>
  </message>
  <message>
   <source>Enter calls it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>回车执行 · ↑ ↓ 选择 · Esc 关闭</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>没有名为“{text}”的内容。</translation>
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
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>匹配项</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>开</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>关</translation>
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
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>无几何</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title} 的虚影</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>接受</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>近看</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action not_visible]</extracomment>
   <translation>此处不可见</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>正在绘制 {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>在此分割：其余部分变为</translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action ignore_finding]</extracomment>
   <translation>忽略此检查结果</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>此处不可见：撤回</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>更改类别为（与已标注的互换）</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title} 的点 {number}</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>合并到</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title}，未确认</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>
    <numerusform>{n} 个点</numerusform>
   </translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>标注</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>评判</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>审核</translation>
  </message>
  <message>
   <source>Desks</source>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>工作台</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>帧</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>场地图</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>元素</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/window/docks.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>相机</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>得分</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>拟合</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>检查</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>地标</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/docks.py, the action plots]</extracomment>
   <translation>图表</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>审核</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>一致性</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>在本页查找</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>用户指南为英文。</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/guide.py, the action guide]</extracomment>
   <translation>用户指南</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>标题</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_columns.py]</extracomment>
   <translation>{one} 或 {other}</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>在图片中</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py, procc_annotator/gui/window/keymap_dialog.py, the action keys]</extracomment>
   <translation>按键</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>搜索：词或按键。点击某行即执行。</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>搜索按键</translation>
  </message>
  <message>
   <source>Actions and their keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>操作及其按键</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>没有含“{text}”的按键、操作或元素。</translation>
  </message>
  <message>
   <source>Choose an element</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>选择元素</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>自定义按键</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>按键 (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}：{action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>搜索：词或按键</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>选择一行，然后按下其按键</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>更改按键</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>搜索</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>一次设置所有按键</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>添加</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>仅这些</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>无按键</translation>
  </message>
  <message>
   <source>Usual keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>默认按键</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>导出…</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>导入…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ 对应两个操作的按键都不起作用：请为其中之一设置其他按键。</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>导出按键</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>导入按键</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ 还有：{what}</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>新按键：在此按下</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>{file}：{error}；按键保持不变</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>操作或元素</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}：{step}</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>面板</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>设置</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>打开</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>第 {number} 帧，共 {count} 帧</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>前往此帧</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>评判 {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>用此源评判</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>实时拟合：模型 {model}</translation>
  </message>
  <message>
   <source>Fit this model to the clicks; auto takes the simplest that they support</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>用此模型拟合点击；auto 采用点击所能支持的最简模型</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>面板 {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>打开此面板并置于最前</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>阈值 {px:g} px</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>用此 tau 评判元素</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>工具栏</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>图片
亮度、对比度、伽马、线条增强：只改变您所看到的</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>已保存 {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>
    <numerusform>未保存：{n} 帧</numerusform>
   </translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>正在保存...</translation>
  </message>
  <message>
   <source>no changes</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>无更改</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>搜索设置</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>{setting}：恢复为 {value}</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>设置</translation>
  </message>
  <message>
   <source>All to their defaults</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>全部恢复默认</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py, the action keymap]</extracomment>
   <translation>更改按键…</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>没有含“{text}”的设置。</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>未指定</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>地面 ±{metres:.2f} m</translation>
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
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>评分 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>“相机 &gt; 停止为数据集评分”可结束</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>比较 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>虚影 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Esc 结束</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>阈值 tau：元素的所有点都更近时即通过（+ 和 -）</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>阈值 tau</translation>
  </message>
  <message>
   <source>Top bar</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>顶栏</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>本帧的状态（“审核”面板）</translation>
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
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>将图片文件夹拖放到此处</translation>
  </message>
  <message>
   <source>Annotations are read from and saved to SoccerNet JSON beside the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>标注以 SoccerNet JSON 形式读取并保存在图片旁。之后拖入相机文件夹，即可用您的点击评判它们。</translation>
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
   <source>unexpected error ({what}); the terminal says more</source>
   <extracomment>[procc_annotator/gui/worker.py]</extracomment>
   <translation>意外错误（{what}）；详情见终端</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/writing.py]</extracomment>
   <translation>请先打开图片文件夹</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>在别处保存的内容</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>已覆盖</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>原始状态</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>已撤回</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>已保存</translation>
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
   <source>Draw and compare what somebody else clicked in the same frames</source>
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
   <source>Field</source>
   <extracomment>[the field american_football, the menus]</extracomment>
   <translation>场地</translation>
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
   <source>Export SoccerNet JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>导出 SoccerNet JSON…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of SoccerNet JSON</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>将所有帧的标注写为 SoccerNet JSON 文件夹或 zip</translation>
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
   <source>Your name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>您的姓名…</translation>
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
   <source>Cancel</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>取消</translation>
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
   <source>Theme, size of texts, and how the window draws, fits and judges</source>
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
   <source>Show the next picture</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>显示下一张图片</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>上一帧</translation>
  </message>
  <message>
   <source>Show the previous picture</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>显示上一张图片</translation>
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
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[the action ignore_finding]</extracomment>
   <translation>在其元素的点改变之前不再显示</translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>检查整个数据集</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>在所有已标注的帧中查找错误类别</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>下一个无标注</translation>
  </message>
  <message>
   <source>Go on to the next frame where nothing is annotated</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>前往下一个没有标注的帧</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>上一个无标注</translation>
  </message>
  <message>
   <source>Go back to the frame before where nothing is annotated</source>
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
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; doubtful frames and annotated ones are left out</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>沿跟踪结果标注镜头的帧，或帧条上所标区段的帧；存疑的帧和已标注的帧除外</translation>
  </message>
  <message>
   <source>Take back the accepted stretch</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>撤回已接受的区段</translation>
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
   <source>Go on to the next frame of the shot that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>前往镜头中下一个已标注的帧</translation>
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
   <source>Go on to the next frame whose track should be looked at</source>
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
   <source>Approve</source>
   <extracomment>[the action approve]</extracomment>
   <translation>批准</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>审核者认为本帧正确</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[the action reject]</extracomment>
   <translation>退回</translation>
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
   <source>Overview of the set…</source>
   <extracomment>[the action overview]</extracomment>
   <translation>数据集总览…</translation>
  </message>
  <message>
   <source>Counts per status and class, progress, time per frame</source>
   <extracomment>[the action overview]</extracomment>
   <translation>各状态和类别的数量、进度、每帧用时</translation>
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
   <source>Write the frame of the video as a picture beside its annotation</source>
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
   <source>Confirm all copied elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>确认所有复制的元素</translation>
  </message>
  <message>
   <source>Copied elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>复制的元素从现在起计入并保存</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>丢弃未确认的元素</translation>
  </message>
  <message>
   <source>Throw away what was copied and nobody touched</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>丢弃复制后无人改动的内容</translation>
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
   <source>Take back last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>撤回最后一点</translation>
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
   <source>Confirm copied element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>确认复制的元素</translation>
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
   <source>Clicks near a painted line go to its centre (hold Ctrl to click beside it)</source>
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
   <source>The ghost, or the chosen element, cannot be seen in this frame; once more takes it back</source>
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
   <source>Draw how wide the paint of the field's lines must appear, beside the projection</source>
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
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>将场地图转向相机</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint; the half that is out of sight leaves its room to the other one</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>场地图下方为相机所在一侧，相机看不到的部分变淡；看不见的半场将空间让给另一半</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>帧条</translation>
  </message>
  <message>
   <source>Below the picture: of a video, or of frames that follow one another, how their cameras do and where they are annotated; of other frames small pictures with their states</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>图片下方：视频或连续帧显示相机的好坏和已标注处；其他则显示带状态的缩略图</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set as plots, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>以图表显示本帧或数据集的误差和 JaC，涵盖所有显示的源</translation>
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
   <source>Draw the sources ticked in the Cameras panel as wireframes beside the active one</source>
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
   <source>Disagreement</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>分歧</translation>
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
   <source>Protocol</source>
   <extracomment>[the menus, the setting protocol]</extracomment>
   <translation>协议</translation>
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
   <source>Leave out</source>
   <extracomment>[the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>排除</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>单应矩阵无法投影的球门、篮筐和球网不计入</translation>
  </message>
  <message>
   <source>Camera fault</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>相机错误</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>当前相机在本帧有误；再按一次撤回判定</translation>
  </message>
  <message>
   <source>Annotation fault</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>标注错误</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>本帧的点击有误；再按一次撤回判定</translation>
  </message>
  <message>
   <source>Fine</source>
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
   <source>Light, dark, or as the system has it</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>浅色、深色或跟随系统</translation>
  </message>
  <message>
   <source>As the system</source>
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
   <source>Size of texts</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>文字大小</translation>
  </message>
  <message>
   <source>How large texts are, of what the system says; from the next start on</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>相对于系统设置的文字大小；下次启动时生效</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>语言</translation>
  </message>
  <message>
   <source>The language of the window; from the next start on. Files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>窗口的语言；下次启动时生效。文件保持不变</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>图片上颜色的含义</translation>
  </message>
  <message>
   <source>Your name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>您的姓名</translation>
  </message>
  <message>
   <source>Whose name points, comments and versions bear; empty: that of the system's user</source>
   <extracomment>[the setting author]</extracomment>
   <translation>点、评论和版本所署的姓名；留空则为系统用户名</translation>
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
   <source>soccernet (official)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>soccernet（官方）</translation>
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
   <source>auto</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>auto</translation>
  </message>
  <message>
   <source>H</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>H</translation>
  </message>
  <message>
   <source>P</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>P</translation>
  </message>
  <message>
   <source>R</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R</translation>
  </message>
  <message>
   <source>R+</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R+</translation>
  </message>
  <message>
   <source>R2</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R2</translation>
  </message>
  <message>
   <source>F</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>F</translation>
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
   <translation>左限制区远侧</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>左罚球线</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左限制区近侧</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>左罚球半圆</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右限制区远侧</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>右罚球线</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右限制区近侧</translation>
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
   <translation>左三分线远侧直段</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左三分线近侧直段</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分弧线</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分线远侧直段</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右三分线近侧直段</translation>
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
   <translation>左球门远柱</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>左球门近柱</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右球门远柱</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右球门近柱</translation>
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
   <translation>左球门左柱</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>左球门右柱</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右球门区</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右球门左柱</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右球门右柱</translation>
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
   <translation>左罚球区近侧线</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球区前沿线</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左罚球区远侧线</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区近侧线</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区前沿线</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右罚球区远侧线</translation>
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
   <translation>左球门区近侧线</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左球门区前沿线</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左球门区远侧线</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区近侧线</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区前沿线</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右球门区远侧线</translation>
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
