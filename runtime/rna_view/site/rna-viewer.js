(()=>{var Xt=class extends Error{constructor(e,t,n){super(`${t?t+": ":""}${n} [${e}]`),this.code=e,this.where=t}};function v(r,e,t){throw new Xt(r,e,t)}var B=class extends Error{};var br=65536,Oa=2**30,bt=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size,this.ranged=!1,this.fetched=e.size}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},On=class r{static async open(e,t=()=>{},n,s=Kt(e)){let i=new r;Object.assign(i,{url:e,progress:t,signal:n,fetched:0,name:s});let o=await i._ask({Range:`bytes=0-${br-1}`}),c=/\/(\d+)$/.exec(o.headers.get("Content-Range")??"");i.ranged=o.status===206&&c!==null;let l=Number(o.headers.get("Content-Length"))||0;i.expected=i.ranged?br:l;let f=i.ranged?br:Oa;return l>f&&await i._tooLong(o,f),i.head=await i._collect(o,f),i.size=i.ranged?Number(c[1]):i.head.length,i}async read(e,t){if(t<=this.head.length)return this.head.subarray(e,t);if(!this.ranged)return this.head.subarray(e,Math.min(t,this.size));let n=await this._ask({Range:`bytes=${e}-${t-1}`});if(n.status!==206)throw new B(`${this.name}: the server forgot about ranges`);let s=await this._collect(n,t-e);if(s.length<t-e)throw new B(`${this.name}: the server sent ${s.length} bytes of ${t-e}`);return s}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let s=new URL(this.url,location.href).protocol==="file:";throw new B(s?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new B(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let n=[],s=0,i=e.body.getReader();for(;;){let{done:l,value:f}=await i.read();if(l)break;s+=f.length,s>t&&await this._tooLong(i,t),n.push(f),this.fetched+=f.length,this.progress(this.fetched,this.expected)}let o=new Uint8Array(s),c=0;for(let l of n)o.set(l,c),c+=l.length;return o}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new B(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function Kt(r){let e=new URL(r,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||r}catch{return e}}var Mn=class{constructor(e){Object.assign(this,{place:e,lines:new Map})}say(e,t=!1,n="page"){e?this.lines.set(n,{text:e,calm:t}):this.lines.delete(n);let s=[...this.lines.values()],i=new Set(s.map(o=>o.text));this.place.hidden=!s.length,this.place.replaceChildren(...[...i].map(o=>Object.assign(document.createElement("span"),{textContent:o}))),this.place.classList.toggle("calm",s.every(o=>o.calm))}},Ps=(r,e,t)=>Math.min(Math.max(r,e),t),Ln=r=>((r+180)%360+360)%360-180;function ut(r){return r<1e6?`${Math.round(r/1e3)} kB`:`${(r/1e6).toFixed(r<1e7?2:1)} MB`}var Fs={azimuth:.6,elevation:.35,fov:30},Cs=89*Math.PI/180,Ma=.95,ze=(r,e,t=1)=>r.map((n,s)=>n+t*e[s]),Jt=(r,e)=>r.map(t=>t*e),Ar=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),La=r=>Jt(r,1/Math.hypot(...r)),zs=([r,e,t],[n,s,i])=>[e*i-t*s,t*n-r*i,r*s-e*n],Er=r=>Math.min(Cs,Math.max(-Cs,r));function Us(r,e,t){let n=ze(r,e,-1),s=Math.hypot(...n);return{azimuth:Math.atan2(n[0],n[2]),elevation:Math.asin(n[1]/s),distance:s,target:e,fov:t}}var Pn=class{constructor(){Object.assign(this,{target:[0,0,0],distance:1,size:1,turntable:0,...Fs})}place(e,t,n,s){let i=e.map(g=>Object.fromEntries(Object.entries(g).filter(([,w])=>w!=null))),{azimuth:o,elevation:c,fov:l,target:f=[],distance:h,share:d=1}=Object.assign({},Fs,...i);Object.assign(this,{azimuth:o,elevation:c,fov:l}),t&&this.frame(t,n,s),this.distance=h??d*this.distance,this.target=this.target.map((g,w)=>f[w]??g)}frame({min:e,max:t},n,s=!1){this.target=Jt(ze(e,t),.5),this.size=Math.hypot(...ze(t,e,-1))/2||1;let i=Ma*Math.tan(this.fov*Math.PI/360),o=Array.from({length:8},(f,h)=>ze([0,1,2].map(d=>(h>>d&1?t:e)[d]),this.target,-1)),l=(s?Array.from({length:16},(f,h)=>h*Math.PI/8):[this.turntable]).flatMap(f=>{let{forward:h,side:d,above:g}=this._axes(f);return o.map(w=>Math.max(Math.abs(Ar(w,g)),Math.abs(Ar(w,d))/n)/i-Ar(w,h))});this.distance=Math.max(...l)||this.size}get position(){return ze(this.target,this._away(this.turntable),this.distance)}turn(e,t){this.azimuth+=e,this.elevation=Er(this.elevation+t)}zoom(e){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*e))}pan(e,t){let{side:n,above:s}=this._axes(),i=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=ze(ze(this.target,n,e*i),s,t*i)}camera(e,t){let{forward:n,side:s,above:i}=this._axes(),o=Math.tan(this.fov*Math.PI/360),c=o*e/t;return{position:this.position,corner:ze(ze(n,s,-c),i,o),stepX:Jt(s,2*c/e),stepY:Jt(i,-2*o/t)}}_away(e){let t=Math.cos(this.elevation),n=this.azimuth+e;return[t*Math.sin(n),Math.sin(this.elevation),t*Math.cos(n)]}_axes(e=this.turntable){let t=Jt(this._away(e),-1),n=La(zs(t,[0,1,0]));return{forward:t,side:n,above:zs(n,t)}}};var Ue=Math.PI/180,Pa={deg:Ue,rad:1},Fa={m:1,cm:.01,mm:.001},Ca={"%":.01};function Cn(r,e){throw new Error(`expected ${r}, found ${JSON.stringify(e)}`)}function Rr(r,e){let[,t,n]=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(r)??[];return Object.hasOwn(e,n??"")?Number(t)*e[n]:null}function Qt(r,e,t){let n=r.trim().split(/\s+/);return n.length!==t.length&&Cn(e,r),n.map((s,i)=>s==="auto"?null:t[i](s)??Cn(e,r))}var St=r=>Rr(r,Pa),Fn=r=>Rr(r,Fa),At=(r,e,t=!1)=>n=>{let s=Number(n);return n.trim()!==""&&s>=r&&s<=e&&(!t||Number.isInteger(s))?s:Cn(`a ${t?"whole ":""}number from ${r} to ${e}`,n)},Et=(...r)=>e=>r.includes(e)?e:Cn(r.join(" or "),e),Rt=r=>r,Ve=()=>!0;function za(r){let e=o=>Fn(o)??Rr(o,Ca),[t,n,s]=Qt(r,"THETA PHI RADIUS, as 45deg 75deg 2m",[St,St,e]),i=r.trim().endsWith("%");return{azimuth:t,elevation:n===null?null:Er(Math.PI/2-n),distance:i?null:s,share:i?s:null}}var Ua=r=>Qt(r,"X Y Z, as 0m 0.5m 0m",[Fn,Fn,Fn]);function Da(r){let[e]=Qt(r,"an angle, as 30deg",[St]);return e===null?null:Math.min(170,Math.max(1,e/Ue))}var Ds=r=>Qt(r,"an angle, as 90deg",[St])[0]/Ue;function $a(r){if(r.trim()==="none")return{sun:0};let e=i=>i>=0?Number(i):null,[t,n,s]=Qt(r,"none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2",[St,St,e]);return{sunAzimuth:(t??40*Ue)/Ue,sunHeight:(n??45*Ue)/Ue,sun:s??2}}var en={src:Rt,alt:Rt,poster:Rt,scene:Rt,environment:Rt,tier:Rt,loading:Et("auto","lazy","eager"),reveal:Et("auto","manual"),"camera-orbit":za,"camera-target":Ua,"field-of-view":Da,sun:$a,"light-rotation":Ds,"environment-intensity":At(0,1e6),ground:Ve,exposure:At(-30,30),"view-transform":Et("srgb","filmic"),"camera-controls":Ve,"disable-zoom":Ve,"disable-pan":Ve,"disable-light":Ve,"touch-action":Et("pan-y","pan-x","none"),"wheel-zoom":Et("focus","always"),"auto-rotate":Ve,"auto-rotate-delay":At(0,1e9),"rotation-per-second":Ds,samples:At(1,1e6,!0),"pixel-ratio":At(.1,8),jitter:At(0,1),"first-look":Et("auto","off")},Un=r=>r.replace(/-(.)/g,(e,t)=>t.toUpperCase()),zn=r=>String(Number(r.toPrecision(6))),kt=r=>`${zn(r)}deg`,$s=r=>`${zn(r)}m`;function tn({azimuth:r,elevation:e,distance:t,target:n,fov:s}){let i=r/Ue,o=i-360*Math.round(i/360);return{cameraOrbit:`${kt(o)} ${kt(90-e/Ue)} ${$s(t)}`,cameraTarget:n.map($s).join(" "),fieldOfView:kt(s)}}function Dn({rotation:r,strength:e,suns:t,sun:n,sunAzimuth:s,sunHeight:i}){return{sun:t||!(n>0)?"none":`${kt(s)} ${kt(i)} ${zn(n)}`,lightRotation:kt(r),environmentIntensity:zn(e)}}var Ha=`
<div id="view" part="view"></div>
<slot></slot>
<div id="poster"><slot name="poster"><img part="poster" alt="" hidden></slot></div>
<div id="over">
  <div id="loading" hidden>
    <slot name="progress-bar"><progress id="bar" part="progress-bar" aria-label="Loading"></progress><span id="bytes"></span></slot>
  </div>
  <p id="notice" part="notice" role="alert" hidden></p>
</div>
<p id="keys" class="spoken">
  Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. Square brackets, Shift and arrow keys, or
  two fingers turn the light. Home resets.
</p>
<p id="status" class="spoken" role="status"></p>
`,Ba=`
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#view { background-color: inherit; }
canvas { display: block; }
canvas:focus-visible { outline: 2px solid #fff; outline-offset: -2px; }
:host([camera-controls]) canvas { cursor: grab; }
:host([camera-controls]) canvas.dragging { cursor: grabbing; }
#poster { pointer-events: none; }
::slotted([slot="poster"]) { pointer-events: auto; }
#poster img { object-fit: contain; }
#over {
  position: absolute; inset: 0; padding: 16px; pointer-events: none; overflow: hidden; box-sizing: border-box;
  display: flex; flex-direction: column; justify-content: flex-end; align-items: center; gap: 10px;
}
#loading { text-align: center; font-variant-numeric: tabular-nums; }
#bar {
  display: block; width: min(60vw, 320px); max-width: 100%; height: 4px; margin-bottom: 6px; border: 0; border-radius: 2px;
  appearance: none; background: #3a3a3a;
}
#bar::-webkit-progress-bar { background: #3a3a3a; border-radius: 2px; }
#bar::-webkit-progress-value { background: #cfcfcf; border-radius: 2px; }
#bar::-moz-progress-bar { background: #cfcfcf; border-radius: 2px; }
#notice {
  max-width: min(100%, 60ch); margin: 0; padding: 10px 16px; border-radius: 6px; pointer-events: auto; text-align: center;
  background: #7a2525; border: 1px solid #a34a4a; overflow-wrap: anywhere;
}
#notice.calm { background: #000c; border-color: #555; }
#notice span { display: block; }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`,$n=null;function Hs(r){let e=r.attachShadow({mode:"open",delegatesFocus:!0});return $n??=new CSSStyleSheet,$n.cssRules.length||$n.replaceSync(Ba),e.adoptedStyleSheets=[$n],e.innerHTML=Ha,e}var Ga=["front","front right","right","back right","back","back left","left","front left"],Bs=20*Math.PI/180;function Gs({azimuth:r,elevation:e}){let t=Math.round(4*r/Math.PI),n=Ga[(t%8+8)%8],s=e>Bs?", from above":e<-Bs?", from below":"";return`View from the ${n}${s}`}var kr={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,RNA_NOTHING:4294967295,RNA_IS_SEGMENT:1,RNA_SURFACE_SHIFT:1,RNA_HAS_BEFORE:1,RNA_HAS_AFTER:2,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,IS_LIGHT:2147483648,MATERIAL_PART:4294967294,CATCHER_PART:4294967293,SUM_GROUPS:5,CAMERA_RAY:1,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,SUN:1,POINT:2,RECTANGLE:3,DISK:4,SPHERE:5,UNIFORM:6,IMAGE:7,TRIANGLES:8},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},RnaRow:{words:16,members:{position:{at:0,type:"u32",count:3},h:{at:3,type:"u32",count:1},axis:{at:4,type:"u32",count:3},reserved:{at:7,type:"u32",count:1},wo:{at:8,type:"u32",count:3},reserved_2:{at:11,type:"u32",count:1},wi:{at:12,type:"u32",count:3},reserved_3:{at:15,type:"u32",count:1}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaPrimitive:{words:4,members:{a:{at:0,type:"u32",count:1},b:{at:1,type:"u32",count:1},c:{at:2,type:"u32",count:1},tag:{at:3,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},own:{at:31,type:"u32",count:1}}},Frame:{words:40,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},list:{at:28,type:"u32",count:1},next_list:{at:29,type:"u32",count:1},table_size:{at:30,type:"u32",count:1},objects:{at:31,type:"u32",count:1},surfaces:{at:32,type:"u32",count:1},lights:{at:33,type:"u32",count:1},albedo:{at:34,type:"u32",count:1},domains:{at:35,type:"u32",count:1},textures:{at:36,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Query:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}},PathQueries:{words:48,members:{at_point:{at:0,record:"Query",count:1},at_light:{at:24,record:"Query",count:1}}},Object:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},step:{at:2,type:"f32",count:1},passes:{at:3,type:"u32",count:1}}},Surface:{words:36,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},textures:{at:20,type:"u32",count:8},through:{at:28,type:"u32",count:1},cutoff:{at:29,type:"f32",count:1},ior:{at:30,type:"f32",count:2},f0:{at:32,type:"f32",count:1}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},sun:{colour:0,axis:3,one_minus_cosine:6},point:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},rectangle:{colour:0,frame:3,half:15},disk:{colour:0,frame:3,radius:15},sphere:{colour:0,centre:3,radius:6},uniform:{colour:0},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},triangles:{colour:0,rotation:3,place:12,scale:15}},viewerLights:{sun:0,environment:1,given:2,aroundPoint:3,mirror:4}};var{constants:ce,records:ge,viewerLights:Sr}=kr;function qs(r){for(let[,e,t]of r.matchAll(/struct (\w+) \{([^}]*)\}/g)){let n={},s=0;for(let[,i,o]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let c=Number(/vec(\d)/.exec(o)?.[1]??1),l=c===3?4:c,f=Math.ceil(s/l)*l;n[i]={at:f,type:o.includes("u32")?"u32":"f32",count:c},s=f+c}ge[e]={words:4*Math.ceil(s/4),members:n}}}function ae(r,e){let t=new Uint32Array(ge[r].words);return Ys(t,new Float32Array(t.buffer),0,r,e),t}var js=Object.entries(Sr).map(([r,e])=>`const LIGHT_${r.replace(/[A-Z]/g,"_$&").toUpperCase()}: u32 = ${e}u;`).join(`
`),We=r=>4*ge[r].words;function Zs(r,e){let t=[];for(let[n,s]of Object.entries(e))[s].flat().forEach((i,o)=>{t[kr.lights[r][n]+o]=i});return Float32Array.from(t,n=>n??0)}function Ys(r,e,t,n,s){for(let[i,o]of Object.entries(s)){let{at:c,type:l,record:f}=ge[n].members[i],h=t+c,d=typeof o=="number"?[o]:o;f?[d].flat().forEach((g,w)=>Ys(r,e,h+w*ge[f].words,f,g)):(l==="f32"?e:r).set(d,h)}}var{words:Nr,members:nn}=ge.RnaNode,De=16,ja=4,Za=24;function Ws(r,e=0){let t=r.length/6,n=Uint32Array.from({length:t},(h,d)=>d),s=new Float32Array(3*t);for(let h=0;h<t;h++)for(let d=0;d<3;d++)s[3*h+d]=.5*(r[6*h+d]+r[6*h+3+d]);let i=new Float32Array(2*Nr*t),o=new Uint32Array(i.buffer),c={boxes:r,centres:s,order:n},l=[[0,t,0,-1]],f=0;for(;l.length;){let[h,d,g,w]=l.pop(),k=Nr*f;f+=1,w>=0&&(o[w+nn.child.at]=e+f-1),Ya(c,h,d);for(let L=0;L<3;L++)i[k+nn.low.at+L]=_e[L],i[k+nn.high.at+L]=_e[3+L];if(d-h<=ja){o[k+nn.child.at]=h,o[k+nn.count.at]=d-h;continue}let S=g<Za?Wa(c,h,d):h;h<S&&S<d||(S=Xa(c,h,d)),l.push([S,d,g+1,k],[h,S,g+1,-1])}return{nodes:o.slice(0,Nr*f),order:n}}function Lr(r,e,t,n){for(let s=0;s<3;s++)r[e+s]=Math.min(r[e+s],t[n+s]),r[e+3+s]=Math.max(r[e+3+s],t[n+3+s])}function Pr(r){for(let e=0;e<r.length;e+=6)for(let t=0;t<3;t++)r[e+t]=1/0,r[e+3+t]=-1/0;return r}var _e=new Float32Array(6),Or=new Float32Array(6*De),Mr=new Uint32Array(De),Ir=new Float64Array(De),Tr=new Float64Array(De);function Ya({boxes:r,order:e},t,n){Pr(_e);for(let s=t;s<n;s++)Lr(_e,0,r,6*e[s])}function Xs({centres:r,order:e},t,n,s){let i=1/0,o=-1/0;for(let c=t;c<n;c++){let l=r[3*e[c]+s];i=Math.min(i,l),o=Math.max(o,l)}return[i,o]}var Ks=(r,e,t)=>Math.min(Math.floor((r-e)/(t-e)*De),De-1);function Va({boxes:r,centres:e,order:t},n,s,i,o,c){Pr(Or),Mr.fill(0);for(let h=n;h<s;h++){let d=Ks(e[3*t[h]+i],o,c);Mr[d]+=1,Lr(Or,6*d,r,6*t[h])}Vs(Tr,De-1,-1),Vs(Ir,0,1);let l=1/0,f=0;for(let h=1;h<De;h++)Ir[h-1]+Tr[h]<l&&(l=Ir[h-1]+Tr[h],f=h);return{cost:l,cut:f,axis:i,low:o,high:c}}function Vs(r,e,t){Pr(_e);for(let n=e,s=0;n>=0&&n<De;n+=t){Lr(_e,0,Or,6*n),s+=Mr[n];let i=_e[3]-_e[0],o=_e[4]-_e[1],c=_e[5]-_e[2];r[n]=s?(i*o+o*c+c*i)*s:1/0}}function Wa(r,e,t){let n={cost:1/0};for(let g=0;g<3;g++){let[w,k]=Xs(r,e,t,g),S=k>w?Va(r,e,t,g,w,k):n;S.cost<n.cost&&(n=S)}if(n.cost===1/0)return e;let{centres:s,order:i}=r,{axis:o,cut:c,low:l,high:f}=n,h=e,d=t-1;for(;h<=d;){let g=i[h];Ks(s[3*g+o],l,f)<c?h++:(i[h]=i[d],i[d--]=g)}return h}function Xa(r,e,t){let{centres:n,order:s}=r,i=[0,1,2].map(c=>{let[l,f]=Xs(r,e,t,c);return f-l}),o=i.indexOf(Math.max(...i));return s.subarray(e,t).sort((c,l)=>n[3*c+o]-n[3*l+o]),Math.floor((e+t)/2)}var{NONE:Ka,OF_NEURAL:Ja,OF_FIBERS:Qa,LETS_THROUGH:Js,HAS_CUTOFF:ec}=ce,Hn=class{constructor(){Object.assign(this,{surfaces:[],textures:[],images:[],imagesLength:0})}ofFibers(e){return this._add({kind:Qa,part:e})}ofTriangles({mesh:e,transmittance:t,normalMaps:n},s){let i=e.indices.length/3,o=Qs(t,i),c=Qs(n,i),l=new Map,f=new Uint32Array(i);for(let h=0;h<i;h++){let d=`${c[h]} ${o[h]}`;l.has(d)||l.set(d,this._ofRecords(s,n[c[h]],t[o[h]])),f[h]=l.get(d)}return f}arrays(){let e=this.surfaces.map(i=>ae("Surface",i)),t=Uint32Array.from([...e,...this.textures].flatMap(i=>[...i])),n=new Uint32Array(this.imagesLength),s=0;for(let i of this.images)n.set(i,s),s+=i.length;return{table:t,images:n,texturesAt:e.reduce((i,o)=>i+o.length/4,0),hasTextures:this.textures.length>0,transmits:this.surfaces.some(({flags:i})=>i&Js)}}_add(e){return this.surfaces.push({normal_map:Ka,...e})-1}_ofRecords(e,t,n){let s={kind:Ja,part:e};return t&&(s.normal_map=this._texture(t.texture)),n&&(s.flags=Js|(n.cutoff==null?0:ec),Object.assign(s,{through:this._texture(n.texture),cutoff:n.cutoff??0,ior:n.ior??[0,0]})),this._add(s)}_texture({values:e,width:t,height:n,channels:s}){let i=new Uint32Array(t*n),o=this.imagesLength;for(let c=0;c<i.length;c++){let[l,f=l,h=s===1?l:0]=e.subarray(s*c,s*(c+1));i[c]=l|f<<8|h<<16}return this.images.push(i),this.imagesLength+=i.length,this.textures.push(ae("Texture",{place:o,size:n<<16|t,row_u:[1,0,0],row_v:[0,1,0]}))-1}};function Qs(r,e){let t=new Int32Array(e).fill(-1);return r.forEach(({triangles:[n,s]},i)=>t.fill(i,n,n+s)),t}var{RNA_HAS_BEFORE:tc,RNA_HAS_AFTER:nc,RNA_IS_SEGMENT:rc,RNA_SURFACE_SHIFT:ei}=ce,rn=ge.RnaPrimitive,Xe=ge.RnaNode;function Bn(r){let e=r.map(sc),t=h=>e.reduce((d,g)=>d+g[h],0),n={primitives:new Uint32Array(rn.words*t("primitives")),points:new Float32Array(4*t("points")),normals:new Float32Array(4*t("normals")),boxes:new Float32Array(6*t("primitives")),surfaces:new Hn,parts:[],extent:0,strands:0};n.harmonics=r.some(({environment:h})=>h?.harmonics)?new Int8Array(16*t("points")):null;let s={primitive:0,point:0},i=[...r.keys()].sort((h,d)=>(r[h].kind==="fiber")-(r[d].kind==="fiber"));for(let h of i){let d=r[h];n.parts[h]={first:s.primitive,fiber:d.kind==="fiber"},d.kind==="fiber"?oc(n,d.curves,h,s):ic(n,d,h,s),d.environment?.harmonics&&n.harmonics.set(d.environment.harmonics,16*s.point),s={primitive:s.primitive+e[h].primitives,point:s.point+e[h].points}}let{nodes:o,order:c}=Ws(n.boxes,1),l=new Uint32Array(n.primitives.length),f=new Uint32Array(c.length);return c.forEach((h,d)=>{l.set(n.primitives.subarray(rn.words*h,rn.words*(h+1)),rn.words*d),f[h]=d}),{...n,boxes:null,...n.surfaces.arrays(),primitives:l,nodes:ac(o),where:f,box:cc(o)}}function sc({kind:r,mesh:e,curves:t}){if(r==="surface"){let s=e.positions.length/3;return{primitives:e.indices.length/3,points:s,normals:s}}let n=t.radii.length;return{primitives:n-(t.offsets.length-1),points:n,normals:0}}function ic(r,e,t,{primitive:n,point:s}){let{positions:i,normals:o,uvs:c,indices:l}=e.mesh,{points:f,boxes:h,primitives:d}=r;for(let w=0;w<i.length/3;w++){let k=4*(s+w);for(let S=0;S<3;S++)f[k+S]=i[3*w+S],r.normals[k+S]=o[3*w+S],r.extent=Math.max(r.extent,Math.abs(i[3*w+S]));f[k+3]=c?c[2*w]:0,r.normals[k+3]=c?c[2*w+1]:0}let g=r.surfaces.ofTriangles(e,t);for(let w=0;w<l.length/3;w++){let k=[0,1,2].map(G=>l[3*w+G]),[S,L,Z]=k.map(G=>G+s);ti(d,n+w,S,L,Z,g[w]<<ei);for(let G=0;G<3;G++){let W=k.map(ne=>i[3*ne+G]);h[6*(n+w)+G]=Math.min(...W),h[6*(n+w)+3+G]=Math.max(...W)}}}function oc(r,e,t,{primitive:n,point:s}){let{boxes:i,primitives:o}=r,{radii:c,offsets:l}=e,f=r.surfaces.ofFibers(t);for(let d=0;d<c.length;d++){let[g,w,k]=e.points.subarray(3*d,3*d+3);r.points.set([g,w,k,c[d]],4*(s+d)),r.extent=Math.max(r.extent,Math.max(Math.abs(g),Math.abs(w),Math.abs(k))+c[d])}let h=n;for(let d=0;d+1<l.length;d++,r.strands++)for(let g=l[d];g+1<l[d+1];g++,h++){let w=(g>l[d]&&tc)|(g+2<l[d+1]&&nc);ti(o,h,s+g,w,r.strands,f<<ei|rc);for(let k=0;k<3;k++){let S=e.points[3*g+k],L=e.points[3*g+3+k],Z=c[g]*1.0005,G=c[g+1]*1.0005;i[6*h+k]=Math.min(S-Z,L-G),i[6*h+3+k]=Math.max(S+Z,L+G)}}}function ti(r,e,t,n,s,i){let{members:o,words:c}=rn,l=c*e;r[l+o.a.at]=t,r[l+o.b.at]=n,r[l+o.c.at]=s,r[l+o.tag.at]=i}function ac(r){let e=new Uint32Array(r.length+Xe.words);return e.set(r.subarray(0,Xe.words)),e[Xe.members.child.at]=0,e[Xe.members.count.at]=1,e.set(r,Xe.words),e}function cc(r){let e=new Float32Array(r.buffer,0,Xe.words),t=({at:n,count:s})=>[...e.subarray(n,n+s)];return{min:t(Xe.members.low),max:t(Xe.members.high)}}var ni=[1024,512];function ri(r){let{rgb:e,width:t,height:n}=fc(r),s=[0,e.length,e.length+n+1,e.length+2*n+3],i=new Float32Array(s[3]+(n+1)*(t+1));i.set(e);let o=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/n))),c=0;for(let l=0;l<=n;l++){let f=o(l)-o(l+1),h=t*Math.max(l-1,0),d=t*Math.min(l,n-1);i[s[1]+l]=f;let g=0;for(let w=0;w<t;w++){let k=(w+1)%t,S=[h+w,h+k,d+w,d+k].reduce((L,Z)=>L+lc(e,Z),0);g+=S/4*f,i[s[3]+l*(t+1)+w+1]=g}c+=g,i[s[2]+l+1]=c}return{floats:i,places:s,total:c,width:t,height:n,up:uc(e,t,n)}}var lc=(r,e)=>.2126*r[3*e]+.7152*r[3*e+1]+.0722*r[3*e+2];function uc(r,e,t){let n=[0,0,0];for(let s=0;s<t;s++){let i=Math.PI*(s+.5)/t,o=2*Math.PI**2*Math.sin(i)/(e*t)*Math.max(0,Math.cos(i));for(let c=0;c<3*e;c++)n[c%3]+=r[3*e*s+c]*o}return n}function fc({rgb:r,width:e,height:t}){let n=Math.max(1,Math.ceil(e/ni[0]),Math.ceil(t/ni[1]));if(n===1)return{rgb:r,width:e,height:t};let s=Math.ceil(e/n),i=Math.ceil(t/n),o=new Float32Array(3*s*i);for(let c=0;c<i;c++)for(let l=0;l<s;l++){let f=0;for(let h=c*n;h<Math.min(t,(c+1)*n);h++)for(let d=l*n;d<Math.min(e,(l+1)*n);d++,f++)for(let g=0;g<3;g++)o[3*(c*s+l)+g]+=r[3*(h*e+d)+g];for(let h=0;h<3;h++)o[3*(c*s+l)+h]/=f}return{rgb:o,width:s,height:i}}function Gn(r){return{rgb:Float32Array.from({length:96},(n,s)=>r[s%3]),width:8,height:4}}function si(){let t=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let s=0;s<64;s++){let i=Math.PI*(s+.5)/64;for(let o=0;o<128;o++){let c=2*Math.PI*((o+.5)/128-.5),l=[Math.sin(i)*Math.sin(c),Math.cos(i),-Math.sin(i)*Math.cos(c)],f=.16+.14*Math.max(0,l[1]);for(let h=0;h<3;h++){let d=f*[.95,1,1.08][h];for(let[g,w,k]of n){let S=(l[0]*g[0]+l[1]*g[1]+l[2]*g[2])/Math.hypot(...g);d+=k[h]*Math.min(1,Math.max(0,(S-w)/.03))}t[3*(s*128+o)+h]=d}}}return{rgb:t,width:128,height:64}}var Fr=0,Cr=1,zr=2,Ur=3,Dr=4,$r=5,Hr=6,Br=7;var Gr=1006;var Nt=1015,It=1016;var Ke=1023;var sn=1028;var Tt=1030;var Je="srgb-linear";var ii=null;function hc(r){let e=r[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=r[1];t&&t.isStackTrace?r[0]+=" "+t.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function oi(...r){r=hc(r);let e="THREE."+r.shift();if(ii)ii("warn",e,...r);else{let t=r[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...r)}}var jf={[Fr]:Fr,[zr]:Hr,[Dr]:Dr,[Ur]:$r,[Cr]:Cr,[Hr]:zr,[Br]:Br,[$r]:Ur};var Yf=Math.PI/180,Vf=180/Math.PI;function ai(r,e,t){return Math.max(e,Math.min(t,r))}var $e=pc();function pc(){let r=new ArrayBuffer(4),e=new Float32Array(r),t=new Uint32Array(r),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){let f=l-127;f<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):f<-14?(n[l]=1024>>-f-14,n[l|256]=1024>>-f-14|32768,s[l]=-f-1,s[l|256]=-f-1):f<=15?(n[l]=f+15<<10,n[l|256]=f+15<<10|32768,s[l]=13,s[l|256]=13):f<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}let i=new Uint32Array(2048),o=new Uint32Array(64),c=new Uint32Array(64);for(let l=1;l<1024;++l){let f=l<<13,h=0;for(;(f&8388608)===0;)f<<=1,h-=8388608;f&=-8388609,h+=947912704,i[l]=f|h}for(let l=1024;l<2048;++l)i[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(c[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:s,mantissaTable:i,exponentTable:o,offsetTable:c}}function dc(r){Math.abs(r)>65504&&oi("DataUtils.toHalfFloat(): Value out of range."),r=ai(r,-65504,65504),$e.floatView[0]=r;let e=$e.uint32View[0],t=e>>23&511;return $e.baseTable[t]+((e&8388607)>>$e.shiftTable[t])}function mc(r){let e=r>>10;return $e.uint32View[0]=$e.mantissaTable[$e.offsetTable[e]+(r&1023)]+$e.exponentTable[e],$e.floatView[0]}var O=class{static toHalfFloat(e){return dc(e)}static fromHalfFloat(e){return mc(e)}};var qn=class{};var ve=Uint8Array,Ot=Uint16Array,gc=Int32Array,ci=new ve([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),li=new ve([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),_c=new ve([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ui=function(r,e){for(var t=new Ot(31),n=0;n<31;++n)t[n]=e+=1<<r[n-1];for(var s=new gc(t[30]),n=1;n<30;++n)for(var i=t[n];i<t[n+1];++i)s[i]=i-t[n]<<5|n;return{b:t,r:s}},fi=ui(ci,2),hi=fi.b,vc=fi.r;hi[28]=258,vc[258]=28;var pi=ui(li,0),yc=pi.b,nh=pi.r,Zr=new Ot(32768);for(X=0;X<32768;++X)He=(X&43690)>>1|(X&21845)<<1,He=(He&52428)>>2|(He&13107)<<2,He=(He&61680)>>4|(He&3855)<<4,Zr[X]=((He&65280)>>8|(He&255)<<8)>>1;var He,X,on=(function(r,e,t){for(var n=r.length,s=0,i=new Ot(e);s<n;++s)r[s]&&++i[r[s]-1];var o=new Ot(e);for(s=1;s<e;++s)o[s]=o[s-1]+i[s-1]<<1;var c;if(t){c=new Ot(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var f=s<<4|r[s],h=e-r[s],d=o[r[s]-1]++<<h,g=d|(1<<h)-1;d<=g;++d)c[Zr[d]>>l]=f}else for(c=new Ot(n),s=0;s<n;++s)r[s]&&(c[s]=Zr[o[r[s]-1]++]>>15-r[s]);return c}),an=new ve(288);for(X=0;X<144;++X)an[X]=8;var X;for(X=144;X<256;++X)an[X]=9;var X;for(X=256;X<280;++X)an[X]=7;var X;for(X=280;X<288;++X)an[X]=8;var X,di=new ve(32);for(X=0;X<32;++X)di[X]=5;var X;var wc=on(an,9,1);var xc=on(di,5,1),qr=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},Ae=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},jr=function(r,e){var t=e/8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},bc=function(r){return(r+7)/8|0},Ac=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new ve(r.subarray(e,t))};var Ec=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ee=function(r,e,t){var n=new Error(e||Ec[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,Ee),!t)throw n;return n},Rc=function(r,e,t,n){var s=r.length,i=n?n.length:0;if(!s||e.f&&!e.l)return t||new ve(0);var o=!t,c=o||e.i!=2,l=e.i;o&&(t=new ve(s*3));var f=function(yn){var wn=t.length;if(yn>wn){var Zt=new ve(Math.max(wn*2,yn));Zt.set(t),t=Zt}},h=e.f||0,d=e.p||0,g=e.b||0,w=e.l,k=e.d,S=e.m,L=e.n,Z=s*8;do{if(!w){h=Ae(r,d,1);var G=Ae(r,d+1,3);if(d+=3,G)if(G==1)w=wc,k=xc,S=9,L=5;else if(G==2){var qe=Ae(r,d,31)+257,je=Ae(r,d+10,15)+4,gr=qe+Ae(r,d+5,31)+1;d+=14;for(var at=new ve(gr),Pe=new ve(19),se=0;se<je;++se)Pe[_c[se]]=Ae(r,d+se*3,7);d+=je*3;for(var gn=qr(Pe),_r=(1<<gn)-1,we=on(Pe,gn,1),se=0;se<gr;){var jt=we[Ae(r,d,_r)];d+=jt&15;var W=jt>>4;if(W<16)at[se++]=W;else{var pe=0,vt=0;for(W==16?(vt=3+Ae(r,d,3),d+=2,pe=at[se-1]):W==17?(vt=3+Ae(r,d,7),d+=3):W==18&&(vt=11+Ae(r,d,127),d+=7);vt--;)at[se++]=pe}}var _n=at.subarray(0,qe),xe=at.subarray(qe);S=qr(_n),L=qr(xe),w=on(_n,S,1),k=on(xe,L,1)}else Ee(1);else{var W=bc(d)+4,ne=r[W-4]|r[W-3]<<8,Ge=W+ne;if(Ge>s){l&&Ee(0);break}c&&f(g+ne),t.set(r.subarray(W,Ge),g),e.b=g+=ne,e.p=d=Ge*8,e.f=h;continue}if(d>Z){l&&Ee(0);break}}c&&f(g+131072);for(var vn=(1<<S)-1,vr=(1<<L)-1,de=d;;de=d){var pe=w[jr(r,d)&vn],ke=pe>>4;if(d+=pe&15,d>Z){l&&Ee(0);break}if(pe||Ee(2),ke<256)t[g++]=ke;else if(ke==256){de=d,w=null;break}else{var be=ke-254;if(ke>264){var se=ke-257,Fe=ci[se];be=Ae(r,d,(1<<Fe)-1)+hi[se],d+=Fe}var ct=k[jr(r,d)&vr],yt=ct>>4;ct||Ee(3),d+=ct&15;var xe=yc[yt];if(yt>3){var Fe=li[yt];xe+=jr(r,d)&(1<<Fe)-1,d+=Fe}if(d>Z){l&&Ee(0);break}c&&f(g+131072);var J=g+be;if(g<xe){var Ce=i-xe,Ze=Math.min(xe,J);for(Ce+g<0&&Ee(3);g<Ze;++g)t[g]=n[Ce+g]}for(;g<J;++g)t[g]=t[g-xe]}}e.l=w,e.p=de,e.b=g,e.f=h,w&&(h=1,e.m=S,e.d=k,e.n=L)}while(!h);return g!=t.length&&o?Ac(t,0,g):t.subarray(0,g)};var kc=new ve(0);var Sc=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&Ee(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&Ee(6,"invalid zlib data: "+(r[1]&32?"need":"unexpected")+" dictionary"),(r[1]>>3&4)+2};function Mt(r,e){return Rc(r.subarray(Sc(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Nc=typeof TextDecoder<"u"&&new TextDecoder,Ic=0;try{Nc.decode(kc,{stream:!0}),Ic=1}catch{}var jn=class extends qn{constructor(e){super(e),this.type=It,this.outputFormat=Ke,this.part=0}parse(e){let at=Math.pow(2.7182818,2.2),Pe=null,se=null;function gn(a,u){let p=0;for(let y=0;y<65536;++y)(y==0||a[y>>3]&1<<(y&7))&&(u[p++]=y);let _=p-1;for(;p<65536;)u[p++]=0;return _}function _r(a){for(let u=0;u<16384;u++)a[u]={},a[u].len=0,a[u].lit=0,a[u].p=null}let we={l:0,c:0,lc:0};function jt(a,u,p,_,y){for(;p<a;)u=u<<8|Is(_,y),p+=8;p-=a,we.l=u>>p&(1<<a)-1,we.c=u,we.lc=p}let pe=new Array(59);function vt(a){for(let p=0;p<=58;++p)pe[p]=0;for(let p=0;p<65537;++p)pe[a[p]]+=1;let u=0;for(let p=58;p>0;--p){let _=u+pe[p]>>1;pe[p]=u,u=_}for(let p=0;p<65537;++p){let _=a[p];_>0&&(a[p]=_|pe[_]++<<6)}}function _n(a,u,p,_,y,b){let m=u,E=0,x=0;for(;_<=y;_++){if(m.value-u.value>p)return!1;jt(6,E,x,a,m);let A=we.l;if(E=we.c,x=we.lc,b[_]=A,A==63){if(m.value-u.value>p)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");jt(8,E,x,a,m);let R=we.l+6;if(E=we.c,x=we.lc,_+R>y+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;R--;)b[_++]=0;_--}else if(A>=59){let R=A-59+2;if(_+R>y+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;R--;)b[_++]=0;_--}}vt(b)}function xe(a){return a&63}function vn(a){return a>>6}function vr(a,u,p,_){for(;u<=p;u++){let y=vn(a[u]),b=xe(a[u]);if(y>>b)throw new Error("THREE.EXRLoader: Invalid table entry");if(b>14){let m=_[y>>b-14];if(m.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(m.lit++,m.p){let E=m.p;m.p=new Array(m.lit);for(let x=0;x<m.lit-1;++x)m.p[x]=E[x]}else m.p=new Array(1);m.p[m.lit-1]=u}else if(b){let m=0;for(let E=1<<14-b;E>0;E--){let x=_[(y<<14-b)+m];if(x.len||x.p)throw new Error("THREE.EXRLoader: Invalid table entry");x.len=b,x.lit=u,m++}}}return!0}let de={c:0,lc:0};function ke(a,u,p,_){a=a<<8|Is(p,_),u+=8,de.c=a,de.lc=u}let be={c:0,lc:0};function Fe(a,u,p,_,y,b,m,E,x){if(a==u){_<8&&(ke(p,_,y,b),p=de.c,_=de.lc),_-=8;let A=p>>_;if(A=new Uint8Array([A])[0],E.value+A>x)return!1;let R=m[E.value-1];for(;A-- >0;)m[E.value++]=R}else if(E.value<x)m[E.value++]=a;else return!1;be.c=p,be.lc=_}function ct(a){return a&65535}function yt(a){let u=ct(a);return u>32767?u-65536:u}let J={a:0,b:0};function Ce(a,u){let p=yt(a),y=yt(u),b=p+(y&1)+(y>>1),m=b,E=b-y;J.a=m,J.b=E}function Ze(a,u){let p=ct(a),_=ct(u),y=p-(_>>1)&65535,b=_+y-32768&65535;J.a=b,J.b=y}function yn(a,u,p,_,y,b,m){let E=m<16384,x=p>y?y:p,A=1,R,I;for(;A<=x;)A<<=1;for(A>>=1,R=A,A>>=1;A>=1;){I=0;let N=I+b*(y-R),M=b*A,F=b*R,T=_*A,P=_*R,D,q,$,Y;for(;I<=N;I+=F){let z=I,C=I+_*(p-R);for(;z<=C;z+=P){let U=z+T,K=z+M,V=K+T;E?(Ce(a[z+u],a[K+u]),D=J.a,$=J.b,Ce(a[U+u],a[V+u]),q=J.a,Y=J.b,Ce(D,q),a[z+u]=J.a,a[U+u]=J.b,Ce($,Y),a[K+u]=J.a,a[V+u]=J.b):(Ze(a[z+u],a[K+u]),D=J.a,$=J.b,Ze(a[U+u],a[V+u]),q=J.a,Y=J.b,Ze(D,q),a[z+u]=J.a,a[U+u]=J.b,Ze($,Y),a[K+u]=J.a,a[V+u]=J.b)}if(p&A){let U=z+M;E?Ce(a[z+u],a[U+u]):Ze(a[z+u],a[U+u]),D=J.a,a[U+u]=J.b,a[z+u]=D}}if(y&A){let z=I,C=I+_*(p-R);for(;z<=C;z+=P){let U=z+T;E?Ce(a[z+u],a[U+u]):Ze(a[z+u],a[U+u]),D=J.a,a[U+u]=J.b,a[z+u]=D}}R=A,A>>=1}return I}function wn(a,u,p,_,y,b,m,E,x){let A=0,R=0,I=m,N=Math.trunc(_.value+(y+7)/8);for(;_.value<N;)for(ke(A,R,p,_),A=de.c,R=de.lc;R>=14;){let F=A>>R-14&16383,T=u[F];if(T.len)R-=T.len,Fe(T.lit,b,A,R,p,_,E,x,I),A=be.c,R=be.lc;else{if(!T.p)throw new Error("THREE.EXRLoader: hufDecode issues");let P;for(P=0;P<T.lit;P++){let D=xe(a[T.p[P]]);for(;R<D&&_.value<N;)ke(A,R,p,_),A=de.c,R=de.lc;if(R>=D&&vn(a[T.p[P]])==(A>>R-D&(1<<D)-1)){R-=D,Fe(T.p[P],b,A,R,p,_,E,x,I),A=be.c,R=be.lc;break}}if(P==T.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let M=8-y&7;for(A>>=M,R-=M;R>0;){let F=u[A<<14-R&16383];if(F.len)R-=F.len,Fe(F.lit,b,A,R,p,_,E,x,I),A=be.c,R=be.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Zt(a,u,p,_,y,b){let m={value:0},E=p.value,x=fe(u,p),A=fe(u,p);p.value+=4;let R=fe(u,p);if(p.value+=4,x<0||x>=65537||A<0||A>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let I=new Array(65537),N=new Array(16384);_r(N);let M=_-(p.value-E);if(_n(a,p,M,x,A,I),R>8*(_-(p.value-E)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");vr(I,x,A,N),wn(I,N,a,p,R,A,b,y,m)}function Qo(a,u,p){for(let _=0;_<p;++_)u[_]=a[u[_]]}function xn(a){for(let u=1;u<a.length;u++){let p=a[u-1]+a[u]-128;a[u]=p}}function bn(a,u){let p=0,_=Math.floor((a.length+1)/2),y=0,b=a.length-1;for(;!(y>b||(u[y++]=a[p++],y>b));)u[y++]=a[_++]}function yr(a){let u=a.byteLength,p=new Array,_=0,y=new DataView(a);for(;u>0;){let b=y.getInt8(_++);if(b<0){let m=-b;u-=m+1;for(let E=0;E<m;E++)p.push(y.getUint8(_++))}else{let m=b;u-=2;let E=y.getUint8(_++);for(let x=0;x<m+1;x++)p.push(E)}}return p}function ea(a,u,p,_,y,b){let m=new DataView(b.buffer),E=p[a.idx[0]].width,x=p[a.idx[0]].height,A=3,R=Math.floor(E/8),I=Math.ceil(E/8),N=Math.ceil(x/8),M=E-(I-1)*8,F=x-(N-1)*8,T={value:0},P=new Array(A),D=new Array(A),q=new Array(A),$=new Array(A),Y=new Array(A);for(let C=0;C<A;++C)Y[C]=u[a.idx[C]],P[C]=C<1?0:P[C-1]+I*N,D[C]=new Float32Array(64),q[C]=new Uint16Array(64),$[C]=new Uint16Array(I*64);for(let C=0;C<N;++C){let U=8;C==N-1&&(U=F);let K=8;for(let H=0;H<I;++H){H==I-1&&(K=M);for(let j=0;j<A;++j)q[j].fill(0),q[j][0]=y[P[j]++],bs(T,_,q[j]),As(q[j],D[j]),Es(D[j]);A==3&&na(D);for(let j=0;j<A;++j)Ss(D[j],$[j],H*64)}let V=0;for(let H=0;H<A;++H){let j=p[a.idx[H]].type;for(let ee=8*C;ee<8*C+U;++ee){V=Y[H][ee];for(let he=0;he<R;++he){let Q=he*64+(ee&7)*8;m.setUint16(V+0*j,$[H][Q+0],!0),m.setUint16(V+2*j,$[H][Q+1],!0),m.setUint16(V+4*j,$[H][Q+2],!0),m.setUint16(V+6*j,$[H][Q+3],!0),m.setUint16(V+8*j,$[H][Q+4],!0),m.setUint16(V+10*j,$[H][Q+5],!0),m.setUint16(V+12*j,$[H][Q+6],!0),m.setUint16(V+14*j,$[H][Q+7],!0),V+=16*j}}if(R!=I)for(let ee=8*C;ee<8*C+U;++ee){let he=Y[H][ee]+8*R*2*j,Q=R*64+(ee&7)*8;for(let Se=0;Se<K;++Se)m.setUint16(he+Se*2*j,$[H][Q+Se],!0)}}}let z=new Uint16Array(E);m=new DataView(b.buffer);for(let C=0;C<A;++C){p[a.idx[C]].decoded=!0;let U=p[a.idx[C]].type;if(p[C].type==2)for(let K=0;K<x;++K){let V=Y[C][K];for(let H=0;H<E;++H)z[H]=m.getUint16(V+H*2*U,!0);for(let H=0;H<E;++H)m.setFloat32(V+H*2*U,O.fromHalfFloat(z[H]),!0)}}}function ta(a,u,p,_,y,b){let m=new DataView(b.buffer),E=p[a],x=E.width,A=E.height,R=Math.ceil(x/8),I=Math.ceil(A/8),N=Math.floor(x/8),M=x-(R-1)*8,F=A-(I-1)*8,T={value:0},P=0,D=new Float32Array(64),q=new Uint16Array(64),$=new Uint16Array(R*64);for(let Y=0;Y<I;++Y){let z=8;Y==I-1&&(z=F);for(let C=0;C<R;++C)q.fill(0),q[0]=y[P++],bs(T,_,q),As(q,D),Es(D),Ss(D,$,C*64);for(let C=8*Y;C<8*Y+z;++C){let U=u[a][C];for(let K=0;K<N;++K){let V=K*64+(C&7)*8;for(let H=0;H<8;++H)m.setUint16(U+H*2*E.type,$[V+H],!0);U+=16*E.type}if(R!=N){let K=N*64+(C&7)*8;for(let V=0;V<M;++V)m.setUint16(U+V*2*E.type,$[K+V],!0)}}}E.decoded=!0}function bs(a,u,p){let _,y=1;for(;y<64;)_=u[a.value],_==65280?y=64:_>>8==255?y+=_&255:(p[y]=_,y++),a.value++}function As(a,u){u[0]=O.fromHalfFloat(a[0]),u[1]=O.fromHalfFloat(a[1]),u[2]=O.fromHalfFloat(a[5]),u[3]=O.fromHalfFloat(a[6]),u[4]=O.fromHalfFloat(a[14]),u[5]=O.fromHalfFloat(a[15]),u[6]=O.fromHalfFloat(a[27]),u[7]=O.fromHalfFloat(a[28]),u[8]=O.fromHalfFloat(a[2]),u[9]=O.fromHalfFloat(a[4]),u[10]=O.fromHalfFloat(a[7]),u[11]=O.fromHalfFloat(a[13]),u[12]=O.fromHalfFloat(a[16]),u[13]=O.fromHalfFloat(a[26]),u[14]=O.fromHalfFloat(a[29]),u[15]=O.fromHalfFloat(a[42]),u[16]=O.fromHalfFloat(a[3]),u[17]=O.fromHalfFloat(a[8]),u[18]=O.fromHalfFloat(a[12]),u[19]=O.fromHalfFloat(a[17]),u[20]=O.fromHalfFloat(a[25]),u[21]=O.fromHalfFloat(a[30]),u[22]=O.fromHalfFloat(a[41]),u[23]=O.fromHalfFloat(a[43]),u[24]=O.fromHalfFloat(a[9]),u[25]=O.fromHalfFloat(a[11]),u[26]=O.fromHalfFloat(a[18]),u[27]=O.fromHalfFloat(a[24]),u[28]=O.fromHalfFloat(a[31]),u[29]=O.fromHalfFloat(a[40]),u[30]=O.fromHalfFloat(a[44]),u[31]=O.fromHalfFloat(a[53]),u[32]=O.fromHalfFloat(a[10]),u[33]=O.fromHalfFloat(a[19]),u[34]=O.fromHalfFloat(a[23]),u[35]=O.fromHalfFloat(a[32]),u[36]=O.fromHalfFloat(a[39]),u[37]=O.fromHalfFloat(a[45]),u[38]=O.fromHalfFloat(a[52]),u[39]=O.fromHalfFloat(a[54]),u[40]=O.fromHalfFloat(a[20]),u[41]=O.fromHalfFloat(a[22]),u[42]=O.fromHalfFloat(a[33]),u[43]=O.fromHalfFloat(a[38]),u[44]=O.fromHalfFloat(a[46]),u[45]=O.fromHalfFloat(a[51]),u[46]=O.fromHalfFloat(a[55]),u[47]=O.fromHalfFloat(a[60]),u[48]=O.fromHalfFloat(a[21]),u[49]=O.fromHalfFloat(a[34]),u[50]=O.fromHalfFloat(a[37]),u[51]=O.fromHalfFloat(a[47]),u[52]=O.fromHalfFloat(a[50]),u[53]=O.fromHalfFloat(a[56]),u[54]=O.fromHalfFloat(a[59]),u[55]=O.fromHalfFloat(a[61]),u[56]=O.fromHalfFloat(a[35]),u[57]=O.fromHalfFloat(a[36]),u[58]=O.fromHalfFloat(a[48]),u[59]=O.fromHalfFloat(a[49]),u[60]=O.fromHalfFloat(a[57]),u[61]=O.fromHalfFloat(a[58]),u[62]=O.fromHalfFloat(a[62]),u[63]=O.fromHalfFloat(a[63])}function Es(a){let u=.5*Math.cos(.7853975),p=.5*Math.cos(3.14159/16),_=.5*Math.cos(3.14159/8),y=.5*Math.cos(3*3.14159/16),b=.5*Math.cos(5*3.14159/16),m=.5*Math.cos(3*3.14159/8),E=.5*Math.cos(7*3.14159/16),x=new Array(4),A=new Array(4),R=new Array(4),I=new Array(4);for(let N=0;N<8;++N){let M=N*8;x[0]=_*a[M+2],x[1]=m*a[M+2],x[2]=_*a[M+6],x[3]=m*a[M+6],A[0]=p*a[M+1]+y*a[M+3]+b*a[M+5]+E*a[M+7],A[1]=y*a[M+1]-E*a[M+3]-p*a[M+5]-b*a[M+7],A[2]=b*a[M+1]-p*a[M+3]+E*a[M+5]+y*a[M+7],A[3]=E*a[M+1]-b*a[M+3]+y*a[M+5]-p*a[M+7],R[0]=u*(a[M+0]+a[M+4]),R[3]=u*(a[M+0]-a[M+4]),R[1]=x[0]+x[3],R[2]=x[1]-x[2],I[0]=R[0]+R[1],I[1]=R[3]+R[2],I[2]=R[3]-R[2],I[3]=R[0]-R[1],a[M+0]=I[0]+A[0],a[M+1]=I[1]+A[1],a[M+2]=I[2]+A[2],a[M+3]=I[3]+A[3],a[M+4]=I[3]-A[3],a[M+5]=I[2]-A[2],a[M+6]=I[1]-A[1],a[M+7]=I[0]-A[0]}for(let N=0;N<8;++N)x[0]=_*a[16+N],x[1]=m*a[16+N],x[2]=_*a[48+N],x[3]=m*a[48+N],A[0]=p*a[8+N]+y*a[24+N]+b*a[40+N]+E*a[56+N],A[1]=y*a[8+N]-E*a[24+N]-p*a[40+N]-b*a[56+N],A[2]=b*a[8+N]-p*a[24+N]+E*a[40+N]+y*a[56+N],A[3]=E*a[8+N]-b*a[24+N]+y*a[40+N]-p*a[56+N],R[0]=u*(a[N]+a[32+N]),R[3]=u*(a[N]-a[32+N]),R[1]=x[0]+x[3],R[2]=x[1]-x[2],I[0]=R[0]+R[1],I[1]=R[3]+R[2],I[2]=R[3]-R[2],I[3]=R[0]-R[1],a[0+N]=I[0]+A[0],a[8+N]=I[1]+A[1],a[16+N]=I[2]+A[2],a[24+N]=I[3]+A[3],a[32+N]=I[3]-A[3],a[40+N]=I[2]-A[2],a[48+N]=I[1]-A[1],a[56+N]=I[0]-A[0]}function na(a){for(let u=0;u<64;++u){let p=a[0][u],_=a[1][u],y=a[2][u];a[0][u]=p+1.5747*y,a[1][u]=p-.1873*_-.4682*y,a[2][u]=p+1.8556*_}}let wr=new Float32Array(1),Rs=new Uint32Array(wr.buffer);function ks(a){wr[0]=a;let u=Rs[0],p=u>>>16&32768,_=u&2147483647;if(_>=1199570944)return p|(_>2139095040?32256:31744);if(_<947912704)return wr[0]=Math.abs(a)+.5,p|Rs[0]-1056964608;let y=_+4095+(_>>>13&1);return p|y-939524096>>>13}function Ss(a,u,p){if(se===null){se=new Uint16Array(65536);for(let _=1;_<65536;++_){if((_&31744)===31744)continue;let y=O.fromHalfFloat(_),b=Math.abs(y),m=b<=1?Math.pow(b,2.2):Math.pow(at,b-1);se[_]=ks(y<0?-m:m)}}for(let _=0;_<64;++_)u[p+_]=se[ks(a[_])]}function An(a){return new DataView(a.array.buffer,a.offset.value,a.size)}function ra(a){let u=a.viewer.buffer.slice(a.offset.value,a.offset.value+a.size),p=new Uint8Array(yr(u)),_=new Uint8Array(p.length);return xn(p),bn(p,_),new DataView(_.buffer)}function xr(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Mt(u),_=new Uint8Array(p.length);return xn(p),bn(p,_),new DataView(_.buffer)}function sa(a){let u=a.viewer,p={value:a.offset.value},_=new Uint16Array(a.columns*a.lines*(a.inputChannels.length*a.type)),y=new Uint8Array(8192),b=0,m=new Array(a.inputChannels.length);for(let F=0,T=a.inputChannels.length;F<T;F++)m[F]={},m[F].start=b,m[F].end=m[F].start,m[F].nx=a.columns,m[F].ny=a.lines,m[F].size=a.type,b+=m[F].nx*m[F].ny*m[F].size;let E=Yt(u,p),x=Yt(u,p);if(x>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(E<=x)for(let F=0;F<x-E+1;F++)y[F+E]=Ye(u,p);let A=new Uint16Array(65536),R=gn(y,A),I=fe(u,p);Zt(a.array,u,p,I,_,b);for(let F=0;F<a.inputChannels.length;++F){let T=m[F];for(let P=0;P<m[F].size;++P)yn(_,T.start+P,T.nx,T.size,T.ny,T.nx*T.size,R)}Qo(A,_,b);let N=0,M=new Uint8Array(_.buffer.byteLength);for(let F=0;F<a.lines;F++)for(let T=0;T<a.inputChannels.length;T++){let P=m[T],D=P.nx*P.size,q=new Uint8Array(_.buffer,P.end*2,D*2);M.set(q,N),N+=D*2,P.end+=D}return new DataView(M.buffer)}function ia(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Mt(u),_=a.inputChannels.length*a.lines*a.columns*a.totalBytes,y=new ArrayBuffer(_),b=new DataView(y),m=0,E=0,x=new Array(4);for(let A=0;A<a.lines;A++)for(let R=0;R<a.inputChannels.length;R++){let I=0;switch(a.inputChannels[R].pixelType){case 1:x[0]=m,x[1]=x[0]+a.columns,m=x[1]+a.columns;for(let M=0;M<a.columns;++M){let F=p[x[0]++]<<8|p[x[1]++];I+=F,b.setUint16(E,I,!0),E+=2}break;case 2:x[0]=m,x[1]=x[0]+a.columns,x[2]=x[1]+a.columns,m=x[2]+a.columns;for(let M=0;M<a.columns;++M){let F=p[x[0]++]<<24|p[x[1]++]<<16|p[x[2]++]<<8;I+=F,b.setUint32(E,I,!0),E+=4}break}}return b}function oa(a){let u=a.array,p=a.offset.value,_=a.columns,y=a.lines,b=a.inputChannels,m=a.totalBytes,E=oe.compression==="B44A_COMPRESSION",x=new Uint8Array(y*_*m),A=new Uint16Array(16),R=0;for(let I=0;I<b.length;I++){let N=b[I],M=N.pixelType*2,F=Math.ceil(_/N.xSampling),T=Math.ceil(y/N.ySampling),P=N.xSampling===1&&N.ySampling===1;if(N.pixelType!==1){for(let $=0;$<T;$++)if(P){let Y=$*_*m+R*_;for(let z=0;z<F*M;z++)x[Y+z]=u[p++]}else p+=F*M;R+=M;continue}let D=Math.ceil(F/4),q=Math.ceil(T/4);for(let $=0;$<q;$++)for(let Y=0;Y<D;Y++){if(E&&u[p+2]>=52){let z=u[p]<<8|u[p+1],C=z&32768?z&32767:~z&65535;A.fill(C),p+=3}else{let z=u[p]<<8|u[p+1],C=u[p+2]>>2,U=32<<C,K=z+((u[p+2]<<4|u[p+3]>>4)&63)*(1<<C)-U&65535,V=K+((u[p+3]<<2|u[p+4]>>6)&63)*(1<<C)-U&65535,H=V+(u[p+4]&63)*(1<<C)-U&65535,j=z+(u[p+5]>>2&63)*(1<<C)-U&65535,ee=K+((u[p+5]<<4|u[p+6]>>4)&63)*(1<<C)-U&65535,he=V+((u[p+6]<<2|u[p+7]>>6)&63)*(1<<C)-U&65535,Q=H+(u[p+7]&63)*(1<<C)-U&65535,Se=j+(u[p+8]>>2&63)*(1<<C)-U&65535,wt=ee+((u[p+8]<<4|u[p+9]>>4)&63)*(1<<C)-U&65535,Vt=he+((u[p+9]<<2|u[p+10]>>6)&63)*(1<<C)-U&65535,Ne=Q+(u[p+10]&63)*(1<<C)-U&65535,lt=Se+(u[p+11]>>2&63)*(1<<C)-U&65535,Nn=wt+((u[p+11]<<4|u[p+12]>>4)&63)*(1<<C)-U&65535,In=Vt+((u[p+12]<<2|u[p+13]>>6)&63)*(1<<C)-U&65535,Tn=Ne+(u[p+13]&63)*(1<<C)-U&65535,Wt=[z,j,Se,lt,K,ee,wt,Nn,V,he,Vt,In,H,Q,Ne,Tn];for(let xt=0;xt<16;xt++)A[xt]=Wt[xt]&32768?Wt[xt]&32767:~Wt[xt]&65535;p+=14}if(N.pLinear){if(Pe===null){Pe=new Uint16Array(65536);for(let z=0;z<65536;z++)if((z&31744)===31744||z>32768)Pe[z]=0;else{let C=O.fromHalfFloat(z);Pe[z]=C<=0?0:O.toHalfFloat(8*Math.log(C))}}for(let z=0;z<16;z++)A[z]=Pe[A[z]]}for(let z=0;z<4;z++){let C=$*4+z;if(!(C>=T))for(let U=0;U<4;U++){let K=Y*4+U;if(K>=F)continue;let V=A[z*4+U];for(let H=0;H<N.ySampling;H++){let j=C*N.ySampling+H;if(!(j>=y))for(let ee=0;ee<N.xSampling;ee++){let he=K*N.xSampling+ee;if(he>=_)continue;let Q=j*_*m+R*_+he*2;x[Q]=V&255,x[Q+1]=V>>8&255}}}}}R+=2}return new DataView(x.buffer)}function Ns(a){let u=a.viewer,p={value:a.offset.value},_=new Uint8Array(a.columns*a.lines*(a.inputChannels.length*a.type*2)),y={version:re(u,p),unknownUncompressedSize:re(u,p),unknownCompressedSize:re(u,p),acCompressedSize:re(u,p),dcCompressedSize:re(u,p),rleCompressedSize:re(u,p),rleUncompressedSize:re(u,p),rleRawSize:re(u,p),totalAcUncompressedCount:re(u,p),totalDcUncompressedCount:re(u,p),acCompression:re(u,p)};if(y.version<2)throw new Error("THREE.EXRLoader: "+oe.compression+" version "+y.version+" is unsupported");let b=new Array,m=Yt(u,p)-2;for(;m>0;){let T=En(u.buffer,p),P=Ye(u,p),D=P>>2&3,q=(P>>4)-1,$=new Int8Array([q])[0],Y=Ye(u,p);b.push({name:T,index:$,type:Y,compression:D}),m-=T.length+3}let E=oe.channels,x=new Array(a.inputChannels.length);for(let T=0;T<a.inputChannels.length;++T){let P=x[T]={},D=E[T];P.name=D.name,P.compression=0,P.decoded=!1,P.type=D.pixelType,P.pLinear=D.pLinear,P.width=a.columns,P.height=a.lines}let A={idx:new Array(3)};for(let T=0;T<a.inputChannels.length;++T){let P=x[T],D=P.name.lastIndexOf("."),q=D>=0?P.name.substring(D+1):P.name;for(let $=0;$<b.length;++$){let Y=b[$];q===Y.name&&P.type===Y.type&&(P.compression=Y.compression,Y.index>=0&&(A.idx[Y.index]=T),P.offset=T)}}let R,I,N;if(y.acCompressedSize>0)switch(y.acCompression){case 0:R=new Uint16Array(y.totalAcUncompressedCount),Zt(a.array,u,p,y.acCompressedSize,R,y.totalAcUncompressedCount);break;case 1:let T=a.array.slice(p.value,p.value+y.totalAcUncompressedCount),P=Mt(T);R=new Uint16Array(P.buffer),p.value+=y.totalAcUncompressedCount;break}if(y.dcCompressedSize>0){let T={array:a.array,offset:p,size:y.dcCompressedSize};I=new Uint16Array(xr(T).buffer),p.value+=y.dcCompressedSize}if(y.rleRawSize>0){let T=a.array.slice(p.value,p.value+y.rleCompressedSize),P=Mt(T);N=yr(P.buffer),p.value+=y.rleCompressedSize}let M=0,F=new Array(x.length);for(let T=0;T<F.length;++T)F[T]=new Array;for(let T=0;T<a.lines;++T)for(let P=0;P<x.length;++P)F[P].push(M),M+=x[P].width*a.type*2;A.idx[0]!==void 0&&x[A.idx[0]]&&ea(A,F,x,R,I,_);for(let T=0;T<x.length;++T){let P=x[T];if(!P.decoded)switch(P.compression){case 2:let D=0,q=0;for(let $=0;$<a.lines;++$){let Y=F[T][D];for(let z=0;z<P.width;++z){for(let C=0;C<2*P.type;++C)_[Y++]=N[q+C*P.width*P.height];q++}D++}break;case 1:ta(T,F,x,R,I,_);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(_.buffer)}function En(a,u){let p=new Uint8Array(a),_=0;for(;p[u.value+_]!=0;)_+=1;let y=new TextDecoder().decode(p.slice(u.value,u.value+_));return u.value=u.value+_+1,y}function aa(a,u,p){let _=new TextDecoder().decode(new Uint8Array(a).slice(u.value,u.value+p));return u.value=u.value+p,_}function ca(a,u){let p=le(a,u),_=fe(a,u);return[p,_]}function la(a,u){let p=fe(a,u),_=fe(a,u);return[p,_]}function le(a,u){let p=a.getInt32(u.value,!0);return u.value=u.value+4,p}function fe(a,u){let p=a.getUint32(u.value,!0);return u.value=u.value+4,p}function Is(a,u){let p=a[u.value];return u.value=u.value+1,p}function Ye(a,u){let p=a.getUint8(u.value);return u.value=u.value+1,p}let re=function(a,u){let p=Number(a.getBigInt64(u.value,!0));return u.value+=8,p};function ie(a,u){let p=a.getFloat32(u.value,!0);return u.value+=4,p}function ua(a,u){return O.toHalfFloat(ie(a,u))}function Yt(a,u){let p=a.getUint16(u.value,!0);return u.value+=2,p}function fa(a,u){return O.fromHalfFloat(Yt(a,u))}function ha(a,u,p,_){let y=p.value,b=[];for(;p.value<y+_-1;){let m=En(u,p),E=le(a,p),x=Ye(a,p);p.value+=3;let A=le(a,p),R=le(a,p);b.push({name:m,pixelType:E,pLinear:x,xSampling:A,ySampling:R})}return p.value+=1,b}function pa(a,u){let p=ie(a,u),_=ie(a,u),y=ie(a,u),b=ie(a,u),m=ie(a,u),E=ie(a,u),x=ie(a,u),A=ie(a,u);return{redX:p,redY:_,greenX:y,greenY:b,blueX:m,blueY:E,whiteX:x,whiteY:A}}function da(a,u){let p=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],_=Ye(a,u);return p[_]}function ma(a,u){let p=le(a,u),_=le(a,u),y=le(a,u),b=le(a,u);return{xMin:p,yMin:_,xMax:y,yMax:b}}function ga(a,u){let p=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],_=Ye(a,u);return p[_]}function _a(a,u){let p=["ENVMAP_LATLONG","ENVMAP_CUBE"],_=Ye(a,u);return p[_]}function va(a,u){let p=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],_=["ROUND_DOWN","ROUND_UP"],y=fe(a,u),b=fe(a,u),m=Ye(a,u);return{xSize:y,ySize:b,levelMode:p[m&15],roundingMode:_[m>>4]}}function ya(a,u){let p=ie(a,u),_=ie(a,u);return[p,_]}function wa(a,u){let p=ie(a,u),_=ie(a,u),y=ie(a,u);return[p,_,y]}function xa(a,u,p,_,y){if(_==="string"||_==="stringvector"||_==="iccProfile")return aa(u,p,y);if(_==="chlist")return ha(a,u,p,y);if(_==="chromaticities")return pa(a,p);if(_==="compression")return da(a,p);if(_==="box2i")return ma(a,p);if(_==="envmap")return _a(a,p);if(_==="tiledesc")return va(a,p);if(_==="lineOrder")return ga(a,p);if(_==="float")return ie(a,p);if(_==="v2f")return ya(a,p);if(_==="v3f")return wa(a,p);if(_==="int")return le(a,p);if(_==="rational")return ca(a,p);if(_==="timecode")return la(a,p);if(_==="preview"||_==="deepImageState"||_==="idmanifest")return p.value+=y,"skipped";p.value+=y}function ba(a,u){let p=Math.log2(a);return u=="ROUND_DOWN"?Math.floor(p):Math.ceil(p)}function Aa(a,u,p){let _=0;switch(a.levelMode){case"ONE_LEVEL":_=1;break;case"MIPMAP_LEVELS":_=ba(Math.max(u,p),a.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return _}function Ts(a,u,p,_){let y=new Array(a);for(let b=0;b<a;b++){let m=1<<b,E=u/m|0;_=="ROUND_UP"&&E*m<u&&(E+=1);let x=Math.max(E,1);y[b]=(x+p-1)/p|0}return y}function Ea(){let a=this,u=a.offset,p={value:0};for(let _=0;_<a.tileCount;_++){let y=le(a.viewer,u),b=le(a.viewer,u);u.value+=8,a.size=fe(a.viewer,u);let m=y*a.blockWidth,E=b*a.blockHeight;a.columns=m+a.blockWidth>a.width?a.width-m:a.blockWidth,a.lines=E+a.blockHeight>a.height?a.height-E:a.blockHeight;let x=a.columns*a.totalBytes,R=a.size<a.lines*x?a.uncompress(a):An(a);u.value+=a.size;for(let I=0;I<a.lines;I++){let N=I*a.columns*a.totalBytes;for(let M=0;M<a.inputChannels.length;M++){let F=oe.channels[M].name,T=a.channelByteOffsets[F]*a.columns,P=a.decodeChannels[F];if(P===void 0)continue;p.value=N+T;let D=(a.height-(1+E+I))*a.outLineWidth;for(let q=0;q<a.columns;q++){let $=D+(q+m)*a.outputChannels+P;a.byteArray[$]=a.getter(R,p)}}}}}function Ra(){let a=this,u=a.offset,p={value:0};for(let _=0;_<a.height/a.blockHeight;_++){let y=le(a.viewer,u)-oe.dataWindow.yMin;a.size=fe(a.viewer,u),a.lines=y+a.blockHeight>a.height?a.height-y:a.blockHeight;let b=a.columns*a.totalBytes,E=a.size<a.lines*b?a.uncompress(a):An(a);u.value+=a.size;for(let x=0;x<a.lines;x++){let A=y+x,R=x*b,I=(a.height-1-A)*a.outLineWidth;for(let N=0;N<a.inputChannels.length;N++){let M=oe.channels[N].name,F=a.channelByteOffsets[M]*a.columns,T=a.decodeChannels[M];if(T!==void 0){p.value=R+F;for(let P=0;P<a.columns;P++){let D=I+P*a.outputChannels+T;a.byteArray[D]=a.getter(E,p)}}}}}}function ka(){let a=this,u=a.chunkOffsets,p={value:0};for(let _=0;_<u.length;_++){let y={value:u[_]};y.value+=4;let b=le(a.viewer,y)-oe.dataWindow.yMin;a.size=fe(a.viewer,y),a.lines=b+a.blockHeight>a.height?a.height-b:a.blockHeight;let m=a.columns*a.totalBytes,E=a.size<a.lines*m,x=a.offset;a.offset=y;let A=E?a.uncompress(a):An(a);a.offset=x;for(let R=0;R<a.lines;R++){let I=b+R,N=R*m,M=(a.height-1-I)*a.outLineWidth;for(let F=0;F<a.inputChannels.length;F++){let T=oe.channels[F].name,P=a.channelByteOffsets[T]*a.columns,D=a.decodeChannels[T];if(D!==void 0){p.value=N+P;for(let q=0;q<a.columns;q++){let $=M+q*a.outputChannels+D;a.byteArray[$]=a.getter(A,p)}}}}}}function Os(a,u,p,_){if(p===0)return null;let y=a.slice(u,u+p);switch(_){case"NO_COMPRESSION":return new DataView(y.buffer,y.byteOffset,y.byteLength);case"RLE_COMPRESSION":{let b=new Uint8Array(yr(y.buffer.slice(y.byteOffset,y.byteOffset+y.byteLength))),m=new Uint8Array(b.length);return xn(b),bn(b,m),new DataView(m.buffer)}case"ZIPS_COMPRESSION":{let b=Mt(y),m=new Uint8Array(b.length);return xn(b),bn(b,m),new DataView(m.buffer)}default:throw new Error("THREE.EXRLoader: "+_+" is unsupported for deep data")}}function Sa(){let a=this,u=a.chunkOffsets,p=a.width,_=a.height,y=a.deepChannels,b=oe.compression,m=a.multiPart,E=a.decodeChannels,x=a.outputChannels,A=a.byteArray instanceof Uint16Array,R=-1;for(let I=0;I<y.length;I++)if(y[I].name==="A"){R=I;break}for(let I=0;I<u.length;I++){let N={value:u[I]};m&&(N.value+=4);let M=le(a.viewer,N)-oe.dataWindow.yMin,F=re(a.viewer,N),T=re(a.viewer,N);re(a.viewer,N);let P=Os(a.array,N.value,F,b);if(N.value+=F,P===null)continue;let D=new Uint32Array(p);for(let U=0;U<p;U++)D[U]=P.getUint32(U*4,!0);let q=D[p-1];if(q===0){N.value+=T;continue}let $=Os(a.array,N.value,T,b),Y=[],z=0;for(let U=0;U<y.length;U++)Y.push(z),z+=q*y[U].bytesPerSample;let C=(_-1-M)*a.outLineWidth;for(let U=0;U<p;U++){let K=U===0?0:D[U-1],H=D[U]-K;if(H===0)continue;let j=new Float32Array(x),ee=0;for(let Q=0;Q<H;Q++){let Se=K+Q,wt=1-ee;if(wt<=0)break;let Vt=1;if(R>=0){let Ne=y[R].bytesPerSample,lt=Y[R]+Se*Ne;Vt=Ne===2?O.fromHalfFloat($.getUint16(lt,!0)):$.getFloat32(lt,!0)}for(let Ne=0;Ne<y.length;Ne++){let lt=y[Ne],Nn=E[lt.name];if(Nn===void 0)continue;let In=lt.bytesPerSample,Tn=Y[Ne]+Se*In,Wt=In===2?O.fromHalfFloat($.getUint16(Tn,!0)):$.getFloat32(Tn,!0);j[Nn]+=Wt*wt}ee+=Vt*wt}E.A!==void 0&&(j[E.A]=ee);let he=C+U*x;for(let Q=0;Q<x;Q++)a.byteArray[he+Q]=A?O.toHalfFloat(j[Q]):j[Q]}}}function Ms(a,u,p){let _={},y=!1;for(;;){let b=En(u,p);if(b==="")break;y=!0;let m=En(u,p),E=fe(a,p),x=xa(a,u,p,m,E);x===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${m}'.`):_[b]=x}return y?_:null}function Na(a,u,p){if(a.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let _=a.getUint8(4),y=a.getUint8(5),b={singleTile:!!(y&2),longName:!!(y&4),deepFormat:!!(y&8),multiPart:!!(y&16)};p.value=8;let m=[];if(b.multiPart){for(;;){let E=Ms(a,u,p);if(E===null)break;E.version=_,E.spec=b,m.push(E)}if(m.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let E=Ms(a,u,p);E.version=_,E.spec=b,m.push(E)}return m}function Ia(a,u,p,_,y,b){let m={size:0,viewer:u,array:p,offset:_,width:a.dataWindow.xMax-a.dataWindow.xMin+1,height:a.dataWindow.yMax-a.dataWindow.yMin+1,inputChannels:a.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Je};switch(a.compression){case"NO_COMPRESSION":m.blockHeight=1,m.uncompress=An;break;case"RLE_COMPRESSION":m.blockHeight=1,m.uncompress=ra;break;case"ZIPS_COMPRESSION":m.blockHeight=1,m.uncompress=xr;break;case"ZIP_COMPRESSION":m.blockHeight=16,m.uncompress=xr;break;case"PIZ_COMPRESSION":m.blockHeight=32,m.uncompress=sa;break;case"PXR24_COMPRESSION":m.blockHeight=16,m.uncompress=ia;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":m.blockHeight=32,m.uncompress=oa;break;case"DWAA_COMPRESSION":m.blockHeight=32,m.uncompress=Ns;break;case"DWAB_COMPRESSION":m.blockHeight=256,m.uncompress=Ns;break;default:throw new Error("THREE.EXRLoader: "+a.compression+" is unsupported")}let E={};for(let N of a.channels)switch(N.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":E[N.name]=!0,m.type=N.pixelType}let x=!1,A=!1;if(E.Y&&E.RY&&E.BY)m.outputChannels=4,m.yCbCr=!0;else if(E.R&&E.G&&E.B)m.outputChannels=4;else if(E.Y)m.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(m.outputChannels){case 4:b==Ke?(x=!E.A,m.format=Ke,m.colorSpace=Je,m.outputChannels=4,m.decodeChannels={R:0,G:1,B:2,A:3}):b==Tt?(m.format=Tt,m.colorSpace=Je,m.outputChannels=2,m.decodeChannels={R:0,G:1}):b==sn?(m.format=sn,m.colorSpace=Je,m.outputChannels=1,m.decodeChannels={R:0}):A=!0;break;case 1:b==Ke?(x=!0,m.format=Ke,m.colorSpace=Je,m.outputChannels=4,m.shouldExpand=!0,m.decodeChannels={Y:0}):b==Tt?(m.format=Tt,m.colorSpace=Je,m.outputChannels=2,m.shouldExpand=!0,m.decodeChannels={Y:0}):b==sn?(m.format=sn,m.colorSpace=Je,m.outputChannels=1,m.decodeChannels={Y:0}):A=!0;break;default:A=!0}if(A)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(m.yCbCr&&(m.format=Ke,m.outputChannels=4,m.decodeChannels={Y:0,RY:1,BY:2},x=!0),m.type==1)switch(y){case Nt:m.getter=fa;break;case It:m.getter=Yt;break}else if(m.type==2)switch(y){case Nt:m.getter=ie;break;case It:m.getter=ua}else throw new Error("THREE.EXRLoader: unsupported pixelType "+m.type+" for "+a.compression+".");m.columns=m.width;let R=m.width*m.height*m.outputChannels;switch(y){case Nt:m.byteArray=new Float32Array(R),x&&m.byteArray.fill(1,0,R);break;case It:m.byteArray=new Uint16Array(R),x&&m.byteArray.fill(15360,0,R);break;default:console.error("THREE.EXRLoader: unsupported type: ",y);break}let I=0;for(let N of a.channels)m.decodeChannels[N.name]!==void 0&&(m.channelByteOffsets[N.name]=I),I+=N.pixelType*2;if(m.totalBytes=I,m.outLineWidth=m.width*m.outputChannels,a.spec.deepFormat){m.deepChannels=[];let N=0;for(let M of a.channels){let F=M.pixelType===0?4:M.pixelType*2;m.deepChannels.push({name:M.name,pixelType:M.pixelType,bytesPerSample:F}),N+=F}m.deepBytesPerSample=N,m.chunkOffsets=a._chunkOffsets,m.multiPart=a.spec.multiPart,m.decode=Sa.bind(m)}else if(a.spec.singleTile){m.blockHeight=a.tiles.ySize,m.blockWidth=a.tiles.xSize;let N=Aa(a.tiles,m.width,m.height),M=Ts(N,m.width,a.tiles.xSize,a.tiles.roundingMode),F=Ts(N,m.height,a.tiles.ySize,a.tiles.roundingMode);m.tileCount=M[0]*F[0];for(let T=0;T<N;T++)for(let P=0;P<F[T];P++)for(let D=0;D<M[T];D++)re(u,_);m.decode=Ea.bind(m)}else if(a.spec.multiPart)m.blockWidth=m.width,m.chunkOffsets=a._chunkOffsets,m.decode=ka.bind(m);else{m.blockWidth=m.width;let N=Math.ceil(m.height/m.blockHeight);for(let M=0;M<N;M++)re(u,_);m.decode=Ra.bind(m)}return m}let Rn={value:0},kn=new DataView(e),Ta=new Uint8Array(e),Sn=Na(kn,e,Rn),Ls=Math.max(0,Math.min(this.part,Sn.length-1)),oe=Sn[Ls];if(oe.spec.multiPart||oe.spec.deepFormat)for(let a=0;a<Sn.length;a++){let u=Sn[a].chunkCount;if(a===Ls){oe._chunkOffsets=[];for(let p=0;p<u;p++)oe._chunkOffsets.push(re(kn,Rn))}else for(let p=0;p<u;p++)re(kn,Rn)}let me=Ia(oe,kn,Ta,Rn,this.type,this.outputFormat);if(me.decode(),me.shouldExpand){let a=me.byteArray;if(this.outputFormat==Ke)for(let u=0;u<a.length;u+=4)a[u+2]=a[u+1]=a[u];else if(this.outputFormat==Tt)for(let u=0;u<a.length;u+=2)a[u+1]=a[u]}if(me.yCbCr){let a=me.byteArray,u=me.width*me.height;if(this.type===It)for(let p=0;p<u;p++){let _=p*4,y=O.fromHalfFloat(a[_]),b=O.fromHalfFloat(a[_+1]),m=O.fromHalfFloat(a[_+2]),E=(1+b)*y,x=(1+m)*y,A=(y-E*.2126-x*.0722)/.7152;a[_]=O.toHalfFloat(Math.max(0,E)),a[_+1]=O.toHalfFloat(Math.max(0,A)),a[_+2]=O.toHalfFloat(Math.max(0,x))}else for(let p=0;p<u;p++){let _=p*4,y=a[_],b=a[_+1],m=a[_+2],E=(1+b)*y,x=(1+m)*y;a[_]=Math.max(0,E),a[_+1]=Math.max(0,(y-E*.2126-x*.0722)/.7152),a[_+2]=Math.max(0,x)}}return{header:oe,width:me.width,height:me.height,data:me.byteArray,format:me.format,colorSpace:me.colorSpace,type:this.type,minFilter:Gr,magFilter:Gr,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var mi=32768,Tc=2**27,gi=2**28,_i=1024,Oc=12,Yr=2**29,vi=1e18;function Zn(r,e,t){let n=Math.max(r,e)>mi||r*e>Tc;if(Math.min(r,e)<1||n)throw new B(`has ${r} x ${e} pixels; from 1 to ${mi} a side, 2^27 in all`);let s=r*e*Oc;if(s>gi&&s>_i*t)throw new B(`has ${r} x ${e} pixels in ${t} bytes; an image above ${gi} bytes of radiance is at most ${_i} times its file`)}var Mc=512,Lc=2048,Pc=4096,Vn=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],Fc=0,Cc=2,zc=2,Uc=4096,yi=["RY","BY"];function wi(r){let{parts:e,flags:t}=qc(r),n=$c(e),s=e[n];Hc(s,e.length,t);for(let G of[s.dataWindow,s.displayWindow])Zn(...Yn(G),r.length);let i=e.reduce((G,W)=>G+Math.max(0,Dc(W)),0);if(i>Yr)throw new B(`has ${i} values in all its channels; at most ${Yr}`);let o=s.dataWindow,c=s.displayWindow,l=Math.max(o[0],c[0]),f=Math.min(o[2],c[2]),h=Math.max(o[1],c[1]),d=Math.min(o[3],c[3]);if(l>f||h>d)throw new B("its data window lies outside its display window");Bc(s);let w=new jn().setDataType(Nt).setPart(n).parse(Gc(r,s).buffer),[k,S]=Yn(c),[L]=Yn(o),Z=new Float32Array(3*k*S);for(let G=h;G<=d;G++){let W=o[3]-G;for(let ne=l;ne<=f;ne++){let Ge=4*(W*L+ne-o[0]),qe=3*((G-c[1])*k+ne-c[0]);for(let je=0;je<3;je++)Z[qe+je]=w.data[Ge+je]}}return{rgb:Z,width:k,height:S}}function Yn([r,e,t,n]){return[t-r+1,n-e+1]}function Dc({dataWindow:r,channels:e}){let[t,n]=Yn(r);return Math.max(0,t)*Math.max(0,n)*e.length}function Wr({channels:r}){let e=new Set(r.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!yi.some(t=>e.has(t))?["Y"]:[]}function $c(r){let e=r.findIndex(s=>Wr(s).length>0);if(e>=0)return e;let t=[...new Set(r.flatMap(({channels:s})=>s.map(({name:i})=>i)))].sort();if(["Y",...yi].every(s=>t.includes(s)))throw new B("has luminance and chroma (Y, RY, BY): save it with R, G and B");let n=t.length>12?` and ${t.length-12} more`:"";throw new B(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${n}`)}function Hc(r,e,t){let n=r.type?r.type.startsWith("deep"):(t&Lc)!==0,s=r.type?r.type==="tiledimage":(t&Mc)!==0,i=o=>{throw new B(o)};n&&i("is a deep image, with any number of samples a pixel: flatten it"),r.envmap&&i("is a cube map: convert it to latitude and longitude"),r.channels.some(({x:o,y:c})=>o!==1||c!==1)&&i("has channels of fewer texels than others: save them all at full size"),Vn[r.compression]===void 0&&i(`has compression ${r.compression}, expected one of ${Vn.join(", ")}`),s&&e>1&&i("has tiles in one of several parts: save it with scan lines"),s&&r.levels===zc&&i("has tiles of several sizes by row and column: save it with one size")}function Bc(r){let e=Wr(r),t=new Set;for(let{name:n,type:s}of r.channels)e.includes(n)&&t.add(["uint32","float16","float32"][s]);if(t.size>1||t.has("uint32"))throw new B(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function Gc(r,e){let t=r.slice(),n=Wr(e),s=e.channels.find(({name:o})=>o===n[0]).type,i=["DWAA","DWAB"].includes(Vn[e.compression]);for(let o of e.channels)if(o.type===Fc&&Vn[e.compression]!=="PXR24"&&(t[o.typeAt]=Cc),["A","Y","RY","BY"].includes(o.name)&&!n.includes(o.name)&&!(i&&o.type===s))for(let l=0;l<o.name.length;l++)t[o.at+l]|=32;return t}function qc(r){let e=new DataView(r.buffer,r.byteOffset,r.length),t=e.getUint32(4,!0),n={bytes:r,view:e,at:8},s=[];do{let i=jc(n);if(i===null)break;s.push(i)}while(t&Pc);if(!s.length)throw new B("broken EXR image: it has no header");return{parts:s,flags:t}}function jc(r){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=r;for(let s=0;;s++){let i=Vr(r);if(i===""){if(s===0)return null;break}let o=Vr(r),c=t.getInt32(r.at,!0),l=r.at+4;if(c<0||l+c>r.bytes.length||s>Uc)throw new B("broken EXR image: an attribute goes past the file's end");i==="channels"&&(e.channels=Zc({...r,at:l})),i==="compression"&&(e.compression=t.getUint8(l)),(i==="dataWindow"||i==="displayWindow")&&(e[i]=[0,4,8,12].map(f=>t.getInt32(l+f,!0))),i==="type"&&(e.type=String.fromCharCode(...r.bytes.subarray(l,l+Math.min(c,64)))),i==="envmap"&&o==="envmap"&&(e.envmap=t.getUint8(l)),i==="tiles"&&(e.levels=t.getUint8(l+8)&15),r.at=l+c}let n=["channels","compression","dataWindow","displayWindow"].find(s=>e[s]===null);if(n!==void 0)throw new B(`broken EXR image: it has no ${n}`);return e}function Zc(r){let e=[];for(;;){let t=r.at,n=Vr(r);if(n==="")return e;let s=r.at,{view:i}=r;e.push({name:n,at:t,typeAt:s,type:i.getInt32(s,!0),x:i.getInt32(s+8,!0),y:i.getInt32(s+12,!0)}),r.at+=16}}function Vr(r){let e=r.bytes.indexOf(0,r.at);if(e<0||e-r.at>255)throw new B("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(r.bytes.subarray(r.at,e));return r.at=e+1,t}var Yc=65536,xi=[8,32767],Vc=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,Wc=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,Xr=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,ye=r=>new B(`broken HDR image${r}`);function bi(r){let e=Xc(r),{count:t,length:n,columns:s,back:i,exposure:o}=e,c=Kc(r,e),l=1/o,[f,h]=s?[t,n]:[n,t],d=new Float32Array(3*f*h);for(let g=0;g<t;g++){let w=i[0]?t-1-g:g;for(let k=0;k<n;k++){let S=i[1]?n-1-k:k,L=4*(g*n+k),Z=3*(s?S*f+w:w*f+S),G=c[L+3],W=G>0?l*2**(G-136):0;for(let ne=0;ne<3;ne++)d[Z+ne]=c[L+ne]*W}}return{rgb:d,width:f,height:h}}function Xc(r){let e=[],t=0,n=-1;for(;n<0||e.length<n+2;){let d=r.subarray(0,Yc).indexOf(10,t);if(d<0)throw ye(": it has no header");e.push(Array.from(r.subarray(t,d),g=>String.fromCharCode(g)).join("")),t=d+1,n<0&&e.at(-1).replace(/\r+$/,"")===""&&(n=e.length-1)}let s=1;for(let d of e.slice(1,n)){let g=d.indexOf("="),[w,k]=g<0?[d,""]:[d.slice(0,g),d.slice(g+1)],S=w.replace(Xr,""),L=k.replace(Xr,"");if(S==="FORMAT"&&L!=="32-bit_rle_rgbe")throw ye(`: format '${L}', expected 32-bit_rle_rgbe`);S==="EXPOSURE"&&(s*=Wc.test(L)?Number(L)||1:0)}if(!(s>0&&s<1/0))throw ye(": EXPOSURE is not a positive number");let i=e[n+1].replace(Xr,""),o=Vc.exec(i);if(o===null||o[2]===o[5])throw ye(`: size '${i.slice(0,40)}', expected such as '-Y height +X width'`);let c=Number(o[3]),l=Number(o[6]),f=o[2]==="X",h=[o[1]+o[2],o[4]+o[5]].map(d=>d==="+Y"||d==="-X");return Zn(...f?[c,l]:[l,c],r.length),{offset:t,count:c,length:l,columns:f,back:h,exposure:s}}function Kc(r,{offset:e,count:t,length:n}){let s=new Uint8Array(4*t*n),i=e;try{for(let o=0;o<t;o++)i=Jc(r,i,s.subarray(4*o*n),n,o)}catch(o){if(r.length-e===s.length)return r.subarray(e);throw o}return s}function Jc(r,e,t,n,s){if(n>=xi[0]&&n<=xi[1]&&e+4<=r.length&&r[e]===2&&r[e+1]===2&&r[e+2]<128){if(r[e+2]*256+r[e+3]!==n)throw ye(`, line ${s}: a run goes past the line's end`);return Qc(r,e+4,t,n,s)}return el(r,e,t,n,s)}function Qc(r,e,t,n,s){for(let i=0;i<4;i++)for(let o=0;o<n;){if(e+2>r.length)throw ye(`, line ${s}: the file ends there`);let c=r[e]>128,l=c?r[e]-128:r[e];if(l===0)throw ye(`, line ${s}: a run of no pixels`);if(o+l>n)throw ye(`, line ${s}: a run goes past the line's end`);if(e+1+(c?1:l)>r.length)throw ye(`, line ${s}: the file ends there`);for(let f=0;f<l;f++)t[4*(o+f)+i]=r[e+1+(c?0:f)];o+=l,e+=c?2:1+l}return e}function el(r,e,t,n,s){let i=0,o=0;for(;i<n;){if(e+4>r.length)throw ye(`, line ${s}: the file ends there`);if(r[e]===1&&r[e+1]===1&&r[e+2]===1){if(i===0)throw ye(`, line ${s}: a run repeats a pixel, but there is none before it`);let c=o>16?1/0:r[e+3]*2**o;if(i+c>n)throw ye(`, line ${s}: a run goes past the line's end`);for(let l=0;l<c;l++)t.copyWithin(4*(i+l),4*(i-1),4*i);i+=c,o+=8}else t.set(r.subarray(e,e+4),4*i),i+=1,o=0;e+=4}return e}var tl=[118,47,49,1],nl=[35,63];function Kr(r,e){let t=new Uint8Array(r),n=i=>i.every((o,c)=>t[c]===o),s=n(tl)?wi:n(nl)?bi:null;if(s===null)throw new B(`${e}: is neither an EXR nor a Radiance HDR image`);try{return rl(s(t))}catch(i){let o=i instanceof B?i.message:`cannot read the image: ${i.message??i}`;throw new B(`${e}: ${o}`)}}function rl(r){let{rgb:e}=r,t=0;for(let n=0;n<e.length;n+=3){let s=!0;for(let i=n;i<n+3;i++)s&&=Number.isFinite(e[i])&&e[i]<=vi,e[i]>0||(e[i]=0);s||t++}if(t)throw new B(`has ${t} texels that are not finite numbers of at most 1e+18`);return r}function Ai(r){return r.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var Ei={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var Wn=Ei.blocks,ft=r=>Wn.find(e=>e.name===r),Xn=(r,e)=>ft(r).width??e;var Qe=22,ht=46,cn=30,Ri=64,ki=256,il=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,Lt="manifest.json",Si=2**20,un=r=>new DataView(r.buffer,r.byteOffset,r.byteLength);async function Ii(r){let{size:e}=r;e===0&&v("FILE_EMPTY",r.name,"the file has no bytes"),e>2**32-2&&v("FILE_TOO_LARGE",r.name,`${e} bytes`);let{count:t,start:n}=await ol(r),s=await r.read(n,e-Qe),i=cl(s,t,n,r.name);return ul(i,n,r.name),new Map(i.map(o=>[o.name,o]))}async function ol(r){let{size:e,name:t}=r,n=un(await r.read(0,Math.min(4,e))),i=e>=4&&n.getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<Qe&&v(i,t,"shorter than the end record of a ZIP archive");let o=un(await r.read(e-Qe,e)),c=e===Qe&&o.getUint32(0,!0)===101010256;o.getUint32(0,!0)!==101010256&&await al(r,i);let l=g=>o.getUint16(g,!0);[4,6,8,10].some(g=>l(g)===65535)&&v("ZIP_ZIP64",t,"a ZIP64 archive"),(l(4)||l(6))&&v("ZIP_ZIP64",t,"an archive of several disks");let f=l(10),h=o.getUint32(12,!0),d=o.getUint32(16,!0);return f>ki&&v("ZIP_TOO_MANY",t,`${f} entries; at most ${ki}`),(l(8)!==f||l(20)!==0||d+h!==e-Qe)&&v("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(c||f===0)&&v("ZIP_ORDER",t,`${Lt} is not the first entry`),{count:f,start:d}}async function al(r,e){let t=await r.read(Math.max(0,r.size-Qe-65535),r.size),n=un(t);for(let s=t.length-Qe;s>=0;s--)n.getUint32(s,!0)===101010256&&s+Qe+n.getUint16(s+20,!0)===t.length&&v("ZIP_DIRECTORY",r.name,"the archive has a comment");v(e,r.name,"the file does not end with the end record of a ZIP archive")}function cl(r,e,t,n){let s=un(r),i=[],o=new Set,c=0;for(let l=0;l<e;l++){(c+ht>r.length||s.getUint32(c,!0)!==33639248)&&v("ZIP_DIRECTORY",n,`the central directory has no header ${l}`);let f=s.getUint16(c+28,!0);(c+ht+f>r.length||s.getUint32(c+30,!0))&&v("ZIP_DIRECTORY",n,`header ${l} of the central directory is malformed`);let h=r.subarray(c+ht,c+ht+f),d=String.fromCharCode(...h);ll(s,c,d,n),(!il.test(d)||d.includes(`
`)||f>200)&&v("ZIP_NAME",n,`an entry is called ${JSON.stringify(d.slice(0,80))}`);let g=d.toLowerCase();o.has(g)&&v("ZIP_DUPLICATE",d,"the name is there twice"),o.add(g),i.push({name:d,size:s.getUint32(c+24,!0),crc:s.getUint32(c+16,!0),header:s.getUint32(c+42,!0),central:r.subarray(c,c+ht+f)}),c+=ht+f}c!==r.length&&v("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:l,header:f,size:h}of i)f+cn+l.length+h>t&&v("ZIP_TRUNCATED",l,`${h} bytes reach past the entries`);return i}function ll(r,e,t,n){let s=l=>r.getUint16(e+l,!0),i=l=>r.getUint32(e+l,!0),o=JSON.stringify(t.slice(0,80));(i(42)===4294967295||i(20)===4294967295||i(24)===4294967295)&&v("ZIP_ZIP64",n,`${o} needs ZIP64`),s(34)&&v("ZIP_ZIP64",n,`${o} is on another disk`),s(8)&1&&v("ZIP_ENCRYPTED",n,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,f])=>s(l)!==f)||i(38))&&v("ZIP_HEADER",n,`${o}: a version, flag, time or attribute is not the fixed one`),s(10)&&v("ZIP_COMPRESSED",n,`${o} is compressed`),i(20)!==i(24)&&v("ZIP_SIZE",n,`${o} has two sizes`)}function ul(r,e,t){let n=[...r].sort((o,c)=>o.header-c.header),s=0;n.forEach((o,c)=>{o.end=c+1<n.length?n[c+1].header:e,o.extra=o.end-o.header-cn-o.name.length-o.size,o.extra<0&&v("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==s&&v("ZIP_GAP",t,`bytes ${s} to ${o.header} are no entry's`),s=o.end});let i=n[0];i.name!==Lt&&v("ZIP_ORDER",t,`${Lt} is not the first entry`),i.size>Si&&v("MANIFEST_TOO_LARGE",Lt,`${i.size} bytes; at most ${Si}`)}function Ti(r,e){let t=un(e),{name:n}=r,s=r.name.length;e.length<r.end-r.header&&v("ZIP_TRUNCATED",n,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===s&&Ni(e.subarray(4,26),r.central.subarray(6,28))&&Ni(e.subarray(cn,cn+s),r.central.subarray(ht))||v("ZIP_LOCAL_HEADER",n,"local and central header differ");let o=t.getUint16(28,!0),c=cn+s;fl(e.subarray(c,c+o),o,n),(r.header+c+o)%Ri&&v("ZIP_ALIGNMENT",n,`data at byte ${r.header+c+o}, no multiple of ${Ri}`),o!==r.extra&&v(o>r.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let l=e.subarray(c+o,c+o+r.size);return hl(l)!==r.crc&&v("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),l}function fl(r,e,t){if(e===0)return;e>=4&&r.length===e&&r[0]===82&&r[1]===78&&r[2]+256*r[3]===e-4&&r.subarray(4).every(s=>s===0)||v("ZIP_EXTRA",t,"the extra field is not zero padding")}var Ni=(r,e)=>r.length===e.length&&r.every((t,n)=>t===e[n]),ln=Array.from({length:4},()=>new Uint32Array(256));for(let r=0;r<256;r++){let e=r;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;ln[0][r]=e>>>0}for(let r=1;r<4;r++)for(let e=0;e<256;e++){let t=ln[r-1][e];ln[r][e]=t>>>8^ln[0][t&255]}function hl(r){let[e,t,n,s]=ln,i=4294967295,o=0;for(;o+4<=r.length;o+=4)i^=r[o]|r[o+1]<<8|r[o+2]<<16|r[o+3]<<24,i=s[i&255]^n[i>>>8&255]^t[i>>>16&255]^e[i>>>24];for(;o<r.length;o++)i=e[(i^r[o])&255]^i>>>8;return(i^4294967295)>>>0}var pl=64,dl=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,ml=/[ \t\n\r]*/y,gl=/[^"\\\u0000-\u001f]*/y,Oi={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function Pt(r,e,t){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{v(t,e,"no UTF-8")}let s=new Jr(n,e,t);s.space(),n[s.at]!=="{"&&v(t,e,"not a JSON object");let i=s.value(1);return s.space(),s.at!==n.length&&s.bad(),i}var Jr=class{constructor(e,t,n){Object.assign(this,{text:e,where:t,code:n,at:0})}bad(e="malformed JSON"){v(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(ml)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>pl&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[i,o]of[["true",!0],["false",!1],["null",null]])if(this.take(i))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(dl);n||this.bad();let s=Number(n[0]);return Number.isFinite(s)||this.notFinite(),s===0?0:s}notFinite(){v("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let s=this.string();t.has(s)&&v("JSON_DUPLICATE_KEY",this.where,`the key "${s}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(s,this.value(e+1))});let n=Object.create(null);for(let[s,i]of t)n[s]=i;return n}string(){let e="";for(this.at+=1;e+=this.match(gl)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),e+=String.fromCharCode(parseInt(n[0],16))}else t in Oi?e+=Oi[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var Mi={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},_l=65536;function Ft(r,e,t,n){let s=e.byteOffset+t;return s%r.BYTES_PER_ELEMENT===0?new r(e.buffer,s,n):new r(e.slice(t,t+n*r.BYTES_PER_ELEMENT).buffer)}function et(r,e,t){r.length<8&&v(t,e,"shorter than a header");let n=new DataView(r.buffer,r.byteOffset).getBigUint64(0,!0);(n>_l||Number(n)>r.length-8)&&v(t,e,`a header of ${n} bytes`);let s=8+Number(n);r[8]!==123&&v(t,e,"the header does not start with {");let{__metadata__:i,...o}=Pt(r.subarray(8,s),e,t);return{tensors:o,metadata:i,data:s}}var Pi=r=>r!==null&&typeof r=="object"&&!Array.isArray(r),Li=r=>Number.isSafeInteger(r)&&r>=0;function tt(r){return Pi(r)&&typeof r.dtype=="string"&&Array.isArray(r.shape)&&r.shape.every(Li)&&Array.isArray(r.data_offsets)&&r.data_offsets.length===2&&r.data_offsets.every(Li)}var nt=r=>r===void 0||Pi(r);function rt(r,{tensors:e,data:t},n,s,i){let o=0,c=n.map(l=>{let{dtype:f,shape:h,data_offsets:[d,g]}=e[l],w=h.reduce((k,S)=>k*S,1);return(d!==o||g-d!==w*Mi[f].BYTES_PER_ELEMENT||t+g>r.length)&&v(i,s,`the bytes of ${l} are not where they must be`),o=g,Ft(Mi[f],r,t+d,w)});return t+o!==r.length&&v(i,s,"bytes behind the last tensor"),c}var Fi=2**26,vl=2**25,yl=2**31,wl={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},xl={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Ci(r,e,t){let n=et(r,e,"GEOMETRY_CONTAINER"),{tensors:s}=n,i="steps"in s||"scales"in s,o=i?xl:wl,c=Object.keys(o);bl(n,o,c,e),i&&t&&v("VERSION_TOO_OLD",e,"quantised curves in a package for readers of 1.0");let l=Object.fromEntries(c.map(S=>[S,s[S].shape])),f=rt(r,n,c,e,"GEOMETRY_RANGE"),h=Object.fromEntries(c.map((S,L)=>[S,f[L]])),d=l.offsets[0]-1,g=l.radii[0];(!(i?l.origins[0]===d&&l.steps[0]===g-d&&l.scales[0]===2:l.points[0]===g)||d<1)&&v("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),Al(h.offsets,g,e);let k=i?El(h,e):h;return Rl(k,e),k}function bl(r,e,t,n){let{tensors:s}=r,i="GEOMETRY_PROFILE",o=Object.keys(s);(o.length!==t.length||t.some(l=>!o.includes(l)))&&v(i,n,`found ${o.join(", ")||"no tensors"}, expected ${t.join(", ")}`),nt(r.metadata)||v(i,n,"__metadata__ is no object");for(let[l,[f,h]]of Object.entries(e)){let d=s[l];tt(d)&&f.includes(d.dtype)&&d.shape.length===h&&(h===1||d.shape[1]===3)||v(i,n,`${l} is not ${f.join(" or ")} of ${h} dimensions`)}((s.points??s.radii).shape[0]>Fi||s.radii.shape[0]>Fi||s.offsets.shape[0]-1>vl)&&v(i,n,"more points or strands than allowed"),r.data%64&&v(i,n,"data does not start at a multiple of 64")}function Al(r,e,t){let n=r[0]===0&&r.at(-1)===e;for(let s=1;s<r.length&&n;s++)n=r[s]>=r[s-1]+2;n||v("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function El({scales:r,origins:e,offsets:t,steps:n,radii:s},i){let[o,c]=r;o>0&&Number.isFinite(o)||v("GEOMETRY_STEPS",i,"steps without length"),e.some(h=>!Number.isFinite(h))&&v("GEOMETRY_NOT_FINITE",i,"an origin is not finite"),(!(c>0&&Number.isFinite(c))||s.some(h=>h===0))&&v("GEOMETRY_RADIUS",i,"a radius that is not above 0");let l=new Float32Array(3*s.length),f=0;for(let h=0;h+1<t.length;h++){for(let d=0;d<3;d++){let g=e[3*h+d],w=0;l[3*t[h]+d]=g;for(let k=t[h]+1,S=f;k<t[h+1];k++,S++)w+=n[3*S+d],Math.abs(w)>yl&&v("GEOMETRY_STEPS",i,`strand ${h} goes too far`),l[3*k+d]=g+o*w}f+=t[h+1]-t[h]-1}return{points:l,radii:Float32Array.from(s,h=>h*c),offsets:t}}function Rl({points:r,radii:e,offsets:t},n){(r.some(s=>!Number.isFinite(s))||e.some(s=>!Number.isFinite(s)))&&v("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let s=0;s+1<t.length;s++)for(let i=t[s]+1;i<t[s+1];i++)r[3*i]===r[3*i-3]&&r[3*i+1]===r[3*i-2]&&r[3*i+2]===r[3*i-1]&&v("GEOMETRY_SEGMENT",n,`two equal points in strand ${s}`);e.some(s=>!(s>0))&&v("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var kl={1:Float32Array,2:Uint8Array,3:Int8Array,6:Int32Array},Sl=64*2**20,Nl=4096,Il=2**18;function Ui(r,e){r.length>Sl&&v("DECODER_TOO_LARGE",e,`${r.length} bytes`);let t=l=>v("DECODER_NOT_ONNX",e,l),n=new Qr(t),s=n.message(r,{1:"one",7:"one",8:"many",20:"many",25:"many"});(!s[7]||!s[1])&&t("no graph, or no IR version"),(s[20].length||s[25].length)&&v("DECODER_NESTED",e,"functions or training information"),Tl(s,n,e);let i=n.message(s[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});i[15].length&&v("DECODER_NESTED",e,"sparse tensors"),i[1].length>Nl&&v("DECODER_GRAPH",e,`${i[1].length} nodes`);let o=i[1].map(l=>Ol(n,l,e)),c=new Map;for(let l of i[5]){let f=Di(n,l,e);c.has(f.name)&&v("DECODER_GRAPH",e,`${f.name} is there twice`),c.set(f.name,f)}return{nodes:o,constants:c,inputs:i[11].map(l=>zi(n,l)),outputs:i[12].map(l=>zi(n,l))}}function Tl(r,e,t){let n=Number(r[1]);n>=7&&n<=10||v("DECODER_VERSION",t,`IR version ${n}`);let s=r[8].map(c=>e.message(c,{1:"one",2:"one"})),i=s.map(c=>e.text(c[1]));i.some(c=>c!==""&&c!=="ai.onnx")&&v("DECODER_DOMAIN",t,`operators of ${i.join(", ")}`);let o=Number(s[0]?.[2]??0);(s.length!==1||o<13||o>21)&&v("DECODER_VERSION",t,`operator set ${o}`)}function Ol(r,e,t){let n=r.message(e,{1:"many",2:"many",4:"one",5:"many",7:"one"}),s=r.text(n[7]);s!==""&&s!=="ai.onnx"&&v("DECODER_DOMAIN",t,`an operator of ${s}`);let i={};for(let o of n[5]){let{1:c,3:l,5:f,6:h,11:d}=r.message(o,{1:"one",3:"one",5:"one",6:"one",11:"many"});(h||d.length)&&v("DECODER_NESTED",t,"a graph within a node"),f&&Di(r,f,t),i[r.text(c)]=l===void 0?null:Number(BigInt.asIntN(64,l))}return{operator:r.text(n[4]),inputs:n[1].map(r.text),outputs:n[2].map(r.text),attributes:i}}function Di(r,e,t){let n=r.message(e,{1:"numbers",2:"one",8:"one",9:"one",13:"many",14:"one"});(n[13].length||n[14])&&v("DECODER_EXTERNAL",t,"data outside the file");let s=n[1].map(Number),i=Number(n[2]??0);(s.length>2||s.some(f=>f>8192)||![1,2,3,6,7,9,10].includes(i))&&v("DECODER_TENSOR",t,`a tensor of type ${i} and shape [${s}]`);let o=s.reduce((f,h)=>f*h,1),c=kl[i],l=c&&n[9]instanceof Uint8Array&&n[9].length===o*c.BYTES_PER_ELEMENT;return{name:r.text(n[8]),type:i,dims:s,values:l?Ft(c,n[9],0,o):null}}function zi(r,e){let t=r.message(e,{1:"one",2:"one"}),n=r.message(t[2]??new Uint8Array,{1:"one"}),s=r.message(n[1]??new Uint8Array,{1:"one",2:"one"}),o=r.message(s[2]??new Uint8Array,{1:"many"})[1].map(c=>{let{1:l,2:f}=r.message(c,{1:"one",2:"one"});return f!==void 0&&r.text(f),l===void 0?null:Number(l)});return{name:r.text(t[1]),type:Number(s[1]??0),dims:o}}var Qr=class{constructor(e){this.wrong=e,this.fields=0,this.text=(t=new Uint8Array)=>{if(!(t instanceof Uint8Array))return e("a name that is no text");try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){e instanceof Uint8Array||this.wrong("a message that is a number");let n={};for(let[s,i]of Object.entries(t))i!=="one"&&(n[s]=[]);for(let s=0;s<e.length;){++this.fields>Il&&this.wrong("too many fields");let i,o;[i,s]=this.varint(e,s),[o,s]=this.value(e,s,Number(i&7n)),this.keep(n,Number(i>>3n),o,t)}return n}keep(e,t,n,s){let i=s[t];if(i==="many")e[t].push(n);else if(i==="one")e[t]!==void 0&&this.wrong(`the field ${t} twice`),e[t]=n;else if(i==="numbers"&&n instanceof Uint8Array)for(let o=0,c;o<n.length;)[c,o]=this.varint(n,o),e[t].push(c);else i==="numbers"&&e[t].push(n)}value(e,t,n){if(n===0)return this.varint(e,t);let s={1:8,5:4}[n];return n===2&&([s,t]=this.varint(e,t),s=Number(s)),(s===void 0||t+s>e.length)&&this.wrong("a field that is cut short"),[e.subarray(t,t+s),t+s]}varint(e,t){let n=0n;for(let s=0n;s<70n&&!(t>=e.length);s+=7n){let i=e[t++];if(n|=BigInt(i&127)<<s,i<128)return[BigInt.asUintN(64,n),t]}return this.wrong("a number that is cut short")}};var Be=1,Ml=2,Ll=3,Pl=6,$i=2**24,Hi=2**16,Bi=2**24;function Gi(r,{columns:e,outputs:t,output:n,precision:s},i){let o=Ui(r,i);Fl(o,e,t,n,i);let c=o.nodes.some(({operator:l})=>/^(De)?[qQ]uantizeLinear$/.test(l));return c!==(s==="int8")&&v("DECODER_PRECISION",i,`arithmetic that is not ${s}`),zl(o,i),new es(o,e,t,c,i).decoder()}function Fl({inputs:r,outputs:e},t,n,s,i){let o=(c,l,f)=>c.length===1&&c[0].name===l&&c[0].type===Be&&c[0].dims.length===2&&c[0].dims[0]===null&&c[0].dims[1]===f;o(r,"queries",t)||v("DECODER_INPUT",i,`not one input queries [N, ${t}]`),o(e,s,n)||v("DECODER_OUTPUT",i,`not one output ${s} [N, ${n}]`)}var Cl=new Set(`Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp
Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization LeakyRelu Less
LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice
Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu Where Xor`.split(/\s+/));function zl({nodes:r,constants:e},t){let n=r.find(({operator:i})=>!Cl.has(i));n&&v("DECODER_OPERATOR",t,`the operator ${n.operator}`);let s=new Set(["queries",...e.keys()]);for(let i of r)(i.inputs.some(o=>o&&!s.has(o))||i.outputs.some(o=>s.has(o)))&&v("DECODER_GRAPH",t,"nodes out of order, or a value made twice"),i.outputs.forEach(o=>s.add(o))}var es=class{constructor({nodes:e,constants:t},n,s,i,o){Object.assign(this,{constants:t,columns:n,outputs:s,int8:i,where:o,width:n,at:0,value:"queries"});let c=({operator:h,inputs:d})=>h==="DequantizeLinear"&&t.has(d[0]);this.dequantizers=new Map(e.filter(c).map(h=>[h.outputs[0],h])),this.chain=e.filter(h=>!c(h)),this.values=this.work=0;let f=[...t.values(),...[...this.dequantizers.values()].map(({inputs:h})=>t.get(h[0]))].reduce((h,{dims:d})=>h+d.reduce((g,w)=>g*w,1),0);f>$i&&v("DECODER_COST",o,`${f} values of constants; at most ${$i}`),this.readers=new Map;for(let h of e.flatMap(d=>d.inputs))this.readers.set(h,(this.readers.get(h)??0)+1)}outside(e){throw new B(`${this.where}: this viewer runs decoders of the profile (spec, 6.4) alone: ${e} [DECODER_PROFILE]`)}get operator(){return this.chain[this.at]?.operator}next(e){let t=this.chain[this.at];return(t?.operator!==e||t.inputs[0]!==this.value||t.outputs.length!==1)&&this.outside(`${t?.operator??"nothing"} where ${e} must be`),(this.readers.get(this.value)!==1||Object.keys(t.attributes).length)&&this.outside(`${e} with attributes, or a value that is read twice`),this.at+=1,this.value=t.outputs[0],t.inputs.slice(1)}spend(e,t=1){this.values+=e,this.work+=t*e,(this.values>Hi||this.work>Bi)&&v("DECODER_COST",this.where,`a query takes ${this.values} values and ${this.work} multiply-adds, or more; at most ${Hi} and ${Bi}`)}constant(e,t,n){let s=this.constants.get(e);return(!s?.values||s.type!==t||s.dims.join()!==n.join())&&this.outside(`${e??"nothing"} is not of type ${t} and shape [${n}]`),s.values}take(e,...t){let n=this.next(e);return e==="MatMul"?this.spend(this.outputs,this.width):this.spend(this.width),n.length!==t.length&&this.outside(`${e} of ${n.length+1} operands`),t.map(([s,i],o)=>this.constant(n[o],s,i))}decoder(){let e=[Be,[]],t=[Be,[this.columns]],[[n],[s]]=this.take("Clip",e,e),i=this.int8?this.take("Mul",t)[0]:null,o=this.int8?this.take("Add",t)[0]:null,c=this.layers(),[[l],[f]]=this.take("Clip",e,e);this.take("Exp");let[[h]]=this.take("Sub",e);(l!==0||h!==1)&&this.outside(`Clip from ${l}, Sub of ${h}`);let[d]=this.operator==="MatMul"?this.take("MatMul",[Be,[this.width,this.outputs]]):this.take("Mul",e);(this.operator||this.dequantizers.size)&&this.outside("nodes behind the last one"),d.length===1&&this.width!==this.outputs&&v("DECODER_LOAD",this.where,`${this.width} values for ${this.outputs} outputs`);let g=d.length===1?{unit:d[0],matrix:null}:{unit:1,matrix:d};return{low:n,high:s,gain:i,offset:o,layers:c,top:f,...g,int8:this.int8,columns:this.columns,outputs:this.outputs}}layers(){let e=[];for(;;){let t=this.int8?this.quantized():null;if(e.push(this.gemm(t)),this.operator==="Clip")return e;this.int8||this.take("Relu")}}quantized(){let e=[[Be,[]],[Ml,[]]],[[t],[n]]=this.take("QuantizeLinear",...e),[[s],[i]]=this.take("DequantizeLinear",...e);return(n||i||t!==s)&&this.outside("two scales, or a zero point"),t}gemm(e){let t=this.next("Gemm");t.length!==2&&this.outside(`Gemm of ${t.length+1} operands`);let n=g=>this.constants.get(g)?.dims.at(-1)??0,s=this.width;if(!this.int8){let g=n(t[0]);return this.spend(g,s),this.width=g,{weight:this.fitting(t[0],Be,s,g),bias:this.constant(t[1],Be,[g]),rows:s,columns:g}}let[i,o]=this.dequantized(t[0],1),[c,l]=this.dequantized(t[1],0),f=n(i);this.spend(f,s);let h=this.constant(o,Be,[f]);return this.constant(l,Be,[f]).some((g,w)=>g!==Math.fround(e*h[w]))&&this.outside("a bias with a scale of its own"),this.width=f,{weight:this.fitting(i,Ll,s,f),bias:this.constant(c,Pl,[f]),rows:s,columns:f,step:e,scales:h}}fitting(e,t,n,s){let i=this.constants.get(e)?.dims??[];return i.length===2&&i[0]!==n&&v("DECODER_LOAD",this.where,`weights for ${i[0]} values, of which there are ${n}`),this.constant(e,t,[n,s])}dequantized(e,t){let n=this.dequantizers.get(e);return this.dequantizers.delete(e),(n?.attributes.axis!==t||n.inputs.length!==2||this.readers.get(e)!==1)&&this.outside(`${e} is no DequantizeLinear of constants along axis ${t}`),n.inputs}};async function qi(r,{elementSize:e,distance:t,size:n},s){let i=await Ul(r,n,s),o=Math.floor(n/e),c=new Uint8Array(n);for(let l=0;l<e;l++){let f=l*o;for(let h=0;h<o;h++)c[h*e+l]=i[f+h]}if(c.set(i.subarray(o*e),o*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],f=new l(c.buffer,0,o);for(let h=t;h<o;h++)f[h]+=f[h-t]}return c}async function Ul(r,e,t){let n=new Uint8Array(e),s=0;try{let i=new Blob([r]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:c}=await i.read();if(o)break;if(s+c.length>e)throw i.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);n.set(c,s),s+=c.length}}catch(i){v("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${i.message})`)}return s!==e&&v("DEFLATE_STREAM",t,`inflates to ${s} bytes, expected ${e}`),n}var Ct={$schema:"https://json-schema.org/draft/2020-12/schema",title:"RNA 1.1 manifest.json",type:"object",if:{required:["parts"]},then:{$ref:"#/$defs/Manifest"},else:{$ref:"#/$defs/ShortManifest"},$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},Manifest:{additionalProperties:!1,description:"manifest.json. `write_package` computes `entries` and the versions; leave them out.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","parts","tiers"],title:"Manifest",type:"object"},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},ShortManifest:{additionalProperties:!1,description:"manifest.json of one part that has nothing new since 1.0.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},tiers:{items:{$ref:"#/$defs/ShortTier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","kind","bounds","geometry","tiers"],title:"ShortManifest",type:"object"},ShortTier:{additionalProperties:!1,description:"A tier of one part, planes and decoder in it.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision","name"],title:"ShortTier",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}}};var zt=16,$l=32,{emission:Wh,...ji}=Ct.$defs.TierPart.properties,Zi={$defs:Ct.$defs,type:"object",required:["parts"],additionalProperties:!1,properties:{parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"object",additionalProperties:!1,required:[...Ct.$defs.TierPart.required,"lobes"],properties:{...ji,lobes:{type:"integer",minimum:2,maximum:$l},visibility:ji.planes}}]}},validation:{type:"array",maxItems:64}}};function Yi(r){let e=r.extensions?.RNA_environment?.parts;return e?.every(t=>t)?e:null}function Vi({parts:r},e,t){r.some(n=>n)||v("FIELD_VALUE",t,"lobes of no part"),r.forEach((n,s)=>{if(!n)return;let i=`${t}/parts/${s}`;n.lobes%2&&v("FIELD_VALUE",`${i}/lobes`,`found ${n.lobes}, expected an even number`);for(let o of n.inputs)ft(o).kinds.includes(e.parts[s].kind)||v("INPUT_KIND",`${i}/inputs`,`${o} is not for this part`);for(let o of Kn([n]))Object.hasOwn(e.entries,o)||v("REFERENCE_MISSING",i,`no entry ${o}`)})}var Kn=r=>r.flatMap(({planes:e,decoder:t,visibility:n})=>[e,t,...n?[n]:[]]);function Wi(r,e,t){let n="ENVIRONMENT_VISIBILITY",s=et(r,t,n),i=s.tensors.harmonics;nt(s.metadata)||v(n,t,"__metadata__ is no object"),(Object.keys(s.tensors).join()!=="harmonics"||!tt(i))&&v(n,t,"not one tensor harmonics");let o=[e,zt];return(i.dtype!=="I8"||i.shape.join()!==o.join())&&v(n,t,`found ${i.dtype} [${i.shape}], expected I8 [${o}]`),s.data%64&&v(n,t,"data does not start at a multiple of 64"),rt(r,s,["harmonics"],t,n)[0]}var ts={object:r=>r!==null&&typeof r=="object"&&!Array.isArray(r),array:Array.isArray,string:r=>typeof r=="string",number:r=>typeof r=="number",integer:r=>Number.isSafeInteger(r),boolean:r=>typeof r=="boolean",null:r=>r===null};function Ut(r,e,t=""){new rs(r).check(r,e,t)}var rs=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,n){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,n),e.if&&this.check(this.fits(e.if,t)?e.then:e.else,t,n);let s=i=>v("FIELD_VALUE",n,`found ${ns(t)}, expected ${i}`);e.type&&!ts[e.type](t)&&s(e.type),"const"in e&&t!==e.const&&s(ns(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&v("INPUT_UNKNOWN",n,`no block ${ns(t)}`),s(e.enum.join(", ")));for(let i of[e.anyOf,e.oneOf])i&&!i.some(o=>this.fits(o,t))&&this.check(i.find(o=>ts[o.type]?.(t))??i[0],t,n);e.not&&this.fits(e.not,t)&&s("another value"),typeof t=="number"&&this.checkNumber(e,t,s),typeof t=="string"&&this.checkString(e,t,s),Array.isArray(t)?this.checkArray(e,t,n,s):ts.object(t)&&this.checkObject(e,t,n)}checkNumber(e,t,n){t<e.minimum&&n(`at least ${e.minimum}`),t>e.maximum&&n(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&n(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&n(`less than ${e.exclusiveMaximum}`)}checkString(e,t,n){t.length<e.minLength&&n(`${e.minLength} characters or more`),t.length>e.maxLength&&n(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&n(e.pattern)}checkArray(e,t,n,s){t.length<e.minItems&&s(`${e.minItems} items or more`),t.length>e.maxItems&&s(`at most ${e.maxItems} items`),t.forEach((i,o)=>{let c=e.prefixItems?.[o]??e.items;c&&this.check(c,i,`${n}/${o}`)}),e.uniqueItems&&new Set(t).size!==t.length&&v("INPUT_UNKNOWN",n,"a name twice")}checkObject(e,t,n){let s=Object.keys(t),i=e.properties??{};for(let o of s)e.additionalProperties===!1&&!Object.hasOwn(i,o)&&v("FIELD_UNKNOWN",`${n}/${o}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},o,`${n}/${o}`);for(let o of e.required??[])Object.hasOwn(t,o)||v("FIELD_MISSING",`${n}/${o}`,"missing");for(let o of s){let c=Object.hasOwn(i,o)?i[o]:e.additionalProperties;c&&this.check(c,t[o],`${n}/${o}`)}}};function ns(r){let e=JSON.stringify(r);return e.length>60?`${e.slice(0,57)}...`:e}var ss={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},fn=(r,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:r,maximum:e}),is={type:"number",minimum:0,maximum:1},pt=r=>({type:"object",properties:r,required:Object.keys(r),additionalProperties:!1}),Xi=2**32-2,Hl=2**20,Bl=64,Ki={RNA_deflate:pt({entries:{type:"object",propertyNames:ss,additionalProperties:pt({elementSize:{enum:[1,2,4]},distance:fn(0),size:fn(0,Xi),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:pt({image:ss,width:fn(1),height:fn(1)}),RNA_standin:pt({parts:{type:"array",minItems:1,maxItems:16,items:pt({baseColor:{type:"array",items:is,minItems:3,maxItems:3},roughness:is,metallic:is})}}),RNA_proxy:pt({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:pt({geometry:ss,height:fn(1)})}]}}}),RNA_environment:Zi},Jn=Object.keys(Ki);function Ji(r){let e=r.extensions??{};for(let t of Jn){let n=`/extensions/${t}`;if(!Object.hasOwn(e,t)){r.extensionsUsed?.includes(t)&&v("FIELD_MISSING",n,"its data is missing");continue}Ut(Ki[t],e[t],n),Gl[t](e[t],r,n)}}function os(r,e,t){Object.hasOwn(r.entries,e)||v("REFERENCE_MISSING",t,`no entry ${e}`)}function as(r,e,t){r.length!==e.parts.length&&v("PARTS_DIFFER",t,`found ${r.length} parts, expected ${e.parts.length}`)}var Gl={RNA_deflate({entries:r},e,t){e.extensionsRequired?.includes("RNA_deflate")||v("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let n=Object.values(r).reduce((s,{size:i})=>s+i,0);n>Xi&&v("FIELD_VALUE",t,`${n} decoded bytes`);for(let[s,{size:i}]of Object.entries(r)){os(e,s,t);let o=Hl+Bl*e.entries[s].size;i>o&&v("DEFLATE_SIZE",`${t}/entries/${s}/size`,`${i} decoded bytes; at most ${o}`)}},RNA_poster({image:r},e,t){os(e,r,t)},RNA_standin({parts:r},e,t){as(r,e,t)},RNA_proxy({parts:r},e,t){as(r,e,t),r.some(n=>n)||v("FIELD_VALUE",t,"a proxy of no part"),r.forEach((n,s)=>{let{transmittance:i,normalMaps:o}=e.parts[s];n&&(i||o)&&v("FIELD_VALUE",t,"a proxy of a part with textures"),(n??[]).forEach(({geometry:c,height:l},f)=>{os(e,c,t),f&&l>=n[f-1].height&&v("FIELD_VALUE",t,"heights must descend")})})},RNA_environment(r,e,t){as(r.parts,e,t),Vi(r,e,t)}};var Qi=[1,1],ql=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function eo(r){let e=Pt(r,"manifest.json","MANIFEST_NOT_JSON");jl(e),Ut(Zl(Ct,e),e);let t=Yl(e);Vl(t),Wl(t),Xl(t);let n=no(to(t.minReaderVersion),Qi)<0;e.parts&&n&&v("VERSION_TOO_OLD","/minReaderVersion","1.0, with `parts`"),Kl(t),Ji(t),Jl(t),Ql(t),tu(t);let s=(t.extensionsUsed??[]).filter(i=>!Jn.includes(i));return{...t,old:n,warnings:s.map(i=>`unknown extension ${i}`)}}var to=r=>r.split(".").map(Number),no=(r,e)=>r[0]-e[0]||r[1]-e[1];function jl(r){"format"in r||v("FIELD_MISSING","/format","missing"),r.format!=="rna"&&v("FORMAT_UNKNOWN","/format","this is no RNA package");let e=r.minReaderVersion;typeof e=="string"&&ql.test(e)&&!e.endsWith(`
`)&&no(to(e),Qi)>0&&v("VERSION_TOO_NEW","/minReaderVersion",`the package needs a reader of version ${e}`);let t=Array.isArray(r.parts)?r.parts:[r];for(let n of t)n?.kind!==void 0&&!["surface","fiber"].includes(n.kind)&&v("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(n.kind)}, expected surface or fiber`);for(let n of Array.isArray(r.extensionsRequired)?r.extensionsRequired:[])typeof n=="string"&&!Jn.includes(n)&&v("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${n}`)}function Zl(r,e){let t="parts"in e?"Manifest":"ShortManifest";return{...r.$defs[t],$defs:r.$defs}}function Yl(r){if(r.parts)return r;let{kind:e,bounds:t,geometry:n,...s}=r,i=r.tiers.map(({name:o,validation:c,cost:l,...f})=>({name:o,validation:c,cost:l,parts:[f]}));return{...s,parts:[{name:"asset",kind:e,bounds:t,geometry:n}],tiers:i}}function Vl(r){r.parts.forEach(({bounds:{min:e,max:t}},n)=>{e.forEach((s,i)=>{Math.fround(t[i])-Math.fround(s)>=1e-18||v("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${i}`)})});for(let e of["wo","wi"]){let t=r.domain[e];for(let{axis:n}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...n)-1)>.001&&v("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function Wl(r){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=r[e].map(({name:s})=>s);new Set(n).size!==n.length&&v(t,`/${e}`,"a name is there twice")}r.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:n},s,i)=>{s&&n>=i[s-1].height&&v("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${s}`,"heights must descend")})})}function Xl(r){r.tiers.forEach((e,t)=>{e.parts.length!==r.parts.length&&v("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${r.parts.length}`),e.parts.forEach((n,s)=>{!n.emission!=!r.tiers[0].parts[s].emission&&v("PARTS_DIFFER",`/tiers/${t}/parts/${s}`,"emission in some tiers alone")})})}function Kl(r){let e=r.extensionsUsed??[];for(let t of[...Object.keys(r.extensions??{}),...r.extensionsRequired??[]])e.includes(t)||v("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function Jl(r){r.tiers.forEach((e,t)=>e.parts.forEach((n,s)=>{let{kind:i}=r.parts[s],o=(c,l)=>{for(let f of c)l(ft(f))||v("INPUT_KIND",`/tiers/${t}/parts/${s}/inputs`,`${f} is not for this part`)};o(n.inputs,({kinds:c})=>c.includes(i)),o(n.emission?.inputs??[],({kinds:c,light:l})=>c.includes(i)&&!l)}))}function Ql(r){r.parts.forEach((e,t)=>{for(let[n,s]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let i=`/parts/${t}/${n}`;e[n]&&e.kind!=="surface"&&v("FIELD_VALUE",i,`of a ${e.kind}`);let o=0;(e[n]??[]).forEach(({triangles:[c,l]},f)=>{c<o&&v(s,`${i}/${f}`,"ranges must ascend and not overlap"),o=c+l})}})}function*eu(r){for(let[e,t]of r.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let n of["transmittance","normalMaps"])for(let[s,i]of(t[n]??[]).entries())yield[`/parts/${e}/${n}/${s}`,i.texture]}for(let[e,t]of r.tiers.entries())for(let[n,s]of t.parts.entries()){let i=`/tiers/${e}/parts/${n}`;yield[`${i}/planes`,s.planes],yield[`${i}/decoder`,s.decoder],s.emission&&(yield[`${i}/emission/decoder`,s.emission.decoder])}}function tu(r){let e=new Set;for(let[n,s]of eu(r))Object.hasOwn(r.entries,s)||v("REFERENCE_MISSING",n,`no entry ${s}`),e.add(s);let t=(r.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(r.entries))!e.has(n)&&!t.some(s=>n.startsWith(s))&&v("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function ro(r,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(r.entries,t)&&v("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:n}]of Object.entries(r.entries)){let s=e.get(t);(!s||t==="manifest.json")&&v("ENTRY_MISSING","/entries",`the archive lacks ${t}`),s.size!==n&&v("ENTRY_SIZE",`/entries/${t}`,`found ${s.size}, expected ${n}`)}}var st={type:"string"},so={type:"array",items:{type:"number"}},Ie=r=>({type:"integer",minimum:r,maximum:2**32-1}),it=r=>({type:"array",minItems:1,maxItems:1,items:r}),Te=(r,e={})=>({type:"object",properties:{...r,...e},required:Object.keys(r),additionalProperties:!1}),io={type:"array",minItems:3,maxItems:3,items:{type:"number"}},oo={const:"KHR_mesh_quantization"};function ao(r){let e=r?[5122,5123,5125,5126]:[5125,5126],t=Te({bufferView:Ie(0),componentType:{enum:e},count:Ie(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Ie(0),normalized:r?{type:"boolean"}:{const:!1},min:so,max:so,name:st}),n=Te({buffer:{const:0},byteLength:Ie(1)},{byteOffset:Ie(0),target:{enum:[34962,34963]},name:st,...r&&{byteStride:{enum:[4,8]}}}),s=Te({POSITION:Ie(0),NORMAL:Ie(0)},{TEXCOORD_0:Ie(0)}),i=Te({attributes:s,indices:Ie(0)},{mode:{const:4}});return Te({asset:Te({version:{const:"2.0"}},{generator:st,copyright:st}),scenes:it(Te({nodes:it({const:0})},{name:st})),nodes:it(Te({mesh:{const:0},...r&&{translation:io,scale:io}},{name:st})),meshes:it(Te({primitives:it(i)},{name:st})),buffers:it(Te({byteLength:Ie(1)},{name:st})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...r&&{extensionsUsed:it(oo),extensionsRequired:it(oo)}},{scene:{const:0},extras:{}})}var nu=ao(!1),ru=ao(!0);function co(r,e){let t="extensionsUsed"in r||"extensionsRequired"in r;try{Ut(t?ru:nu,r)}catch(n){v("GEOMETRY_PROFILE",e,`${n.where}: not as meshes of packages are`)}return t&&su(r.nodes[0],e),iu(r,t,e),t}function su({scale:[r,e,t]},n){r>0&&r===e&&r===t||v("GEOMETRY_PROFILE",n,`the scale ${[r,e,t]}`)}function iu(r,e,t){let{attributes:n,indices:s}=r.meshes[0].primitives[0],i=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[c,l]of[...Object.entries(n),["indices",s]]){let f=r.accessors[l],h=f&&r.bufferViews[f.bufferView];if(!h)continue;let[d,g]=i[c];d.includes(f.type)&&g.some(([k,S,L])=>f.componentType===k&&(f.normalized??!1)===S&&h.byteStride===L)||v("GEOMETRY_PROFILE",t,`the accessor of ${c}`)}r.accessors[s]?.componentType===5123&&r.accessors[n.POSITION]?.count>=65535&&v("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var ou={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},au={SCALAR:1,VEC2:2,VEC3:3};function lo(r,e,t){let{json:n,bin:s}=cu(r,e),i=co(n,e);i&&t&&v("VERSION_TOO_OLD",e,"a quantised mesh in a package for readers of 1.0");let o=n.buffers[0].byteLength;(o>s.length||s.length-o>3)&&v("GEOMETRY_RANGE",e,`a buffer of ${o} bytes in a chunk of ${s.length}`);let c=n.meshes[0].primitives[0],l=d=>lu(n,s.subarray(0,o),d,e),f={positions:l(c.attributes.POSITION),normals:l(c.attributes.NORMAL),uvs:"TEXCOORD_0"in c.attributes?l(c.attributes.TEXCOORD_0):null,indices:l(c.indices)};uu(f,e),fu(n.accessors[c.attributes.POSITION],f.positions,i,e);let h=i?hu(f,n.nodes[0]):f;return h.indices=Uint32Array.from(f.indices),pu(h,e),h}function cu(r,e){let t="GEOMETRY_CONTAINER",n=new DataView(r.buffer,r.byteOffset,r.length);(r.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&v(t,e,"no binary glTF 2.0"),n.getUint32(8,!0)!==r.length&&v(t,e,"the length in the header is not that of the entry");let s=[];for(let i=12;i<r.length;){i+8>r.length&&v(t,e,"a chunk is cut short");let o=n.getUint32(i,!0),c=n.getUint32(i+4,!0);(o%4||i+8+o>r.length)&&v(t,e,`a chunk of ${o} bytes`),s.push([c,r.subarray(i+8,i+8+o)]),i+=8+o}return s.map(([i])=>i).join()!==[1313821514,5130562].join()&&v(t,e,"not the chunks JSON and BIN"),s[0][1].length>65536&&v(t,e,"JSON of more than 64 KiB"),{json:Pt(s[0][1],e,t),bin:s[1][1]}}function lu(r,e,t,n){let s=r.accessors[t];s||v("GEOMETRY_RANGE",n,`no accessor ${t}`);let i=r.bufferViews[s.bufferView];i||v("GEOMETRY_RANGE",n,`no buffer view ${s.bufferView}`);let o=ou[s.componentType],c=au[s.type],l=o.BYTES_PER_ELEMENT*c,f=i.byteStride??l,h=(i.byteOffset??0)+(s.byteOffset??0),d=(s.byteOffset??0)+f*(s.count-1)+l;(d>i.byteLength||(i.byteOffset??0)+i.byteLength>e.length)&&v("GEOMETRY_RANGE",n,`accessor ${t} reaches past its bytes`),h%4&&v("GEOMETRY_PROFILE",n,`accessor ${t} is not aligned`);let g=f===l?Ft(o,e,h,c*s.count):new o(c*s.count);if(f!==l){let w=Ft(o,e,h,Math.floor(d-(s.byteOffset??0))/o.BYTES_PER_ELEMENT),k=f/o.BYTES_PER_ELEMENT;for(let S=0;S<s.count;S++)for(let L=0;L<c;L++)g[c*S+L]=w[k*S+L]}return Object.assign(g,{items:c})}function uu({positions:r,normals:e,uvs:t,indices:n},s){let i=r.length/3;(e.length!==r.length||t&&t.length!==2*i||!i)&&v("GEOMETRY_ARRAY",s,"attributes of different counts"),(n.length%3||!n.length)&&v("GEOMETRY_ARRAY",s,"part of a triangle")}function fu(r,e,t,n){["min","max"].every(i=>{if(r[i]?.length!==3)return!1;for(let o=0;o<3;o++){let c=e[o];for(let f=o;f<e.length;f+=3)(i==="min"?e[f]<c:e[f]>c)&&(c=e[f]);if((t?r[i][o]:Math.fround(r[i][o]))!==c&&Number.isFinite(c))return!1}return!0})||v("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function hu({positions:r,normals:e,uvs:t},{translation:n,scale:s}){return{positions:Float32Array.from(r,(i,o)=>n[o%3]+s[0]*i),normals:Float32Array.from(e,i=>Math.max(i/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,i=>i/65535):t)}}function pu({positions:r,normals:e,uvs:t,indices:n},s){for(let o of[r,e,t??[]])for(let c=0;c<o.length;c++)Number.isFinite(o[c])||v("GEOMETRY_NOT_FINITE",s,"an attribute is not finite");let i=r.length/3;for(let o=0;o<n.length;o++)n[o]>=i&&v("GEOMETRY_INDEX",s,`vertex ${n[o]} of ${i}`);for(let o=0;o<e.length;o+=3){let c=Math.hypot(e[o],e[o+1],e[o+2]);Math.abs(c-1)>.001&&v("GEOMETRY_NORMAL",s,`a normal of length ${c}`)}}var du={float16:"F16",float32:"F32",int8:"I8"},cs=1e18;function ls(r,{planePrecision:e,resolution:t,channels:n},s){let i=et(r,s,"PLANES_HEADER"),{tensors:o}=i,c=e==="int8",l=c?{scales:["F32",[3,n]],planes:["I8",[3,t,t,n]]}:{planes:[du[e],[3,t,t,n]]},f=Object.keys(l),h=Object.keys(o);nt(i.metadata)||v("PLANES_TENSOR",s,"__metadata__ is no object"),(h.length!==f.length||f.some(k=>!h.includes(k)))&&v("PLANES_TENSOR",s,`found ${h.join(", ")||"no tensors"}, expected ${f.join(", ")}`);for(let k of f)tt(o[k])||v("PLANES_HEADER",s,`${k} is no tensor`);for(let k of f){let[S,L]=l[k],Z=o[k];Z.dtype!==S&&v("PLANES_DTYPE",s,`${k}: found ${Z.dtype}, expected ${S}`),Z.shape.join()!==L.join()&&v("PLANES_SHAPE",s,`${k}: found [${Z.shape}], expected [${L}]`)}let d=rt(r,i,f,s,"PLANES_HEADER");i.data%64&&v("PLANES_ALIGNMENT",s,"data does not start at a multiple of 64");let g=d.at(-1),w=c?d[0]:null;return mu(e,g,w,s),{values:g,scales:w,resolution:t,channels:n,precision:e}}function mu(r,e,t,n){let s=()=>v("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${cs}`);if(r==="int8")t.some(i=>!(Math.abs(i)*128<=cs))&&s();else if(r==="float16")for(let i=0;i<e.length;i++)(e[i]&31744)===31744&&s();else for(let i=0;i<e.length;i++)Math.abs(e[i])<=cs||s()}var gu=8192;function uo(r,e,t,n,s){let i=et(r,n,s),o=i.tensors[e];nt(i.metadata)||v(s,n,"__metadata__ is no object"),(Object.keys(i.tensors).join()!==e||!tt(o))&&v(s,n,`not one tensor ${e}`);let[c,l,f]=o.shape,h=o.shape.length===3&&[c,l].every(g=>g>=1&&g<=gu);(o.dtype!=="U8"||!h||!t.includes(f))&&v(s,n,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${t.join(" or ")}]`),i.data%64&&v(s,n,"data does not start at a multiple of 64");let[d]=rt(r,i,[e],n,s);return{values:d,height:c,width:l,channels:f}}function fo(r,e,t){let n="TRANSMITTANCE_TEXTURE",s=uo(r,"transmittance",[1,3],t,n);return e.cutoff!==void 0&&s.channels!==1&&v(n,t,"a cutoff of a coloured texture"),s}function ho(r,e){return uo(r,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function us({triangles:[r,e]},t,n,s,i){r+e>n.indices.length/3&&v(`${i}_RANGE`,s,`triangles ${r} to ${r+e} of ${n.indices.length/3}`),(i==="NORMAL_MAP"||t.width*t.height>1)&&!n.uvs&&v(`${i}_UV`,s,"the mesh has no texture coordinates")}var _u=65536,Dt=class r{static async open(e){let t=new r;return t.source=e,t.directory=await Ii(e),t.cache=new Map,t.manifest=eo(await t._stored(Lt)),ro(t.manifest,t.directory),t.environment=Yi(t.manifest),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(n=>n.name===e):this.manifest.tiers[0];if(!t){let n=this.manifest.tiers.map(s=>s.name).join(", ");v("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${n}`)}return t}bytesOf(e){return this._ranges([...new Set([...this._entriesOf(this.tier(e)),...Kn(this.environment??[])])]).reduce((t,[n,s])=>t+s-n,0)}async load(e,{wantsLobes:t=!1}={}){let n=this.tier(e),s=this._entriesOf(n);await this._fetch(s);let i=new Map;for(let c of s)i.set(c,await this._data(c));let o=this.manifest.parts.map((c,l)=>this._part(c,n.parts[l],l,i));return{name:n.name,tier:n,parts:o,warnings:t?await this._addEnvironment(o,n,i):[]}}async _addEnvironment(e,t,n){if(!this.environment)return[];try{let s=Kn(this.environment).filter(o=>!n.has(o));await this._fetch(s);for(let o of s)n.set(o,await this._data(o));return this.environment.map((o,c)=>this._environment(e[c],o,t.parts[c],n)).forEach((o,c)=>{e[c].environment=o}),[]}catch(s){if(!(s instanceof B))throw s;return[`no first look: ${s.message}`]}}_environment(e,t,n,s){let{inputs:i,lobes:o,visibility:c}=t,l=(e.mesh?.positions??e.curves.points).length/3,h=["planes","resolution","channels","planePrecision"].every(w=>t[w]===n[w])?e.planes:ls(s.get(t.planes),t,t.planes),d=c?Wi(s.get(c),l,c):null,g=c?zt:0;return{inputs:i,lobes:o,harmonics:d,planes:h,...fs(s,t,t,"environment",9*o,g)}}async posterImage(){return this.poster?(await this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,n,s){let{kind:i,bounds:o,geometry:c}=e,l=this.manifest.old,f=`/parts/${n}`,h=s.get(c),d={name:e.name,kind:i,bounds:vu(o),inputs:t.inputs};return i==="surface"?d.mesh=lo(h,c,l):d.curves=Ci(h,c,l),d.transmittance=(e.transmittance??[]).map(g=>{let w=fo(s.get(g.texture),g,g.texture);return us(g,w,d.mesh,f,"TRANSMITTANCE"),{...g,texture:w}}),d.normalMaps=(e.normalMaps??[]).map(g=>{let w=ho(s.get(g.texture),g.texture);return us(g,w,d.mesh,f,"NORMAL_MAP"),{...g,texture:w}}),d.planes=ls(s.get(t.planes),t,t.planes),d.transport=fs(s,t,t,"transport",6),d.emission=t.emission?{inputs:t.emission.inputs,...fs(s,t,t.emission,"emission",3)}:null,d}_entriesOf(e){let t=[];for(let n of this.manifest.parts){t.push(n.geometry);for(let s of[...n.transmittance??[],...n.normalMaps??[]])t.push(s.texture)}for(let n of e.parts)t.push(n.planes,n.decoder),n.emission&&t.push(n.emission.decoder);return[...new Set(t)]}_ranges(e){let t=e.map(s=>this.directory.get(s)).sort((s,i)=>s.header-i.header),n=[];for(let{header:s,end:i}of t){let o=n.at(-1);o&&s-o[1]<=_u?o[1]=i:n.push([s,i])}return n}async _fetch(e){let t=e.filter(n=>!this.cache.has(n));this.source.expected=this.source.ranged?this.source.fetched+this._ranges(t).reduce((n,[s,i])=>n+i-s,0):this.source.size;for(let[n,s]of this._ranges(t)){let i=await this.source.read(n,s);for(let o of t){let c=this.directory.get(o);c.header>=n&&c.end<=s&&this.cache.set(o,i.subarray(c.header-n,c.end-n))}}}async _stored(e){let t=this.directory.get(e),n=this.cache.get(e)??await this.source.read(t.header,t.end);return Ti(t,n)}async _data(e){let t=await this._stored(e);await po(t,this.manifest.entries[e].sha256,e);let n=this.manifest.extensions?.RNA_deflate?.entries[e];if(!n)return t;let s=await qi(t,n,e);return await po(s,n.sha256,e),s}};function fs(r,e,t,n,s,i=0){let c={columns:t.inputs.reduce((l,f)=>l+Xn(f,e.channels),i),outputs:s,output:n,precision:t.decoderPrecision};return Gi(r.get(t.decoder),c,t.decoder)}function vu({min:r,max:e}){return{min:r.map(Math.fround),max:e.map(Math.fround)}}async function po(r,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",r))].map(i=>i.toString(16).padStart(2,"0")).join("")!==e&&v("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var yu=[64,67,71];function mo(r){let{backgroundColor:e}=getComputedStyle(r);return(/^rgb\((\d+), (\d+), (\d+)\)$/.exec(e)?.slice(1).map(Number)??yu).map(n=>n/255).map(n=>n<=.04045?n/12.92:((n+.055)/1.055)**2.4)}var wu=["maxStorageBufferBindingSize","maxBufferSize"];async function go(){let r=await navigator.gpu?.requestAdapter({powerPreference:"high-performance"});if(!r){let t=navigator.gpu?"WebGPU has no adapter here":isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine";throw new B(`${t}: only the poster is shown`)}let e=Object.fromEntries(wu.map(t=>[t,r.limits[t]]));return r.requestDevice({requiredLimits:e})}function te(r,e,t=GPUBufferUsage.STORAGE,n="a buffer"){let s=typeof e=="number"?e:e.byteLength,i=Math.max(16,Math.ceil(s/16)*16),o=r.limits.maxStorageBufferBindingSize;if(i>o)throw new B(`${n} takes ${ut(i)}; this GPU allows ${ut(o)}`);let c=r.createBuffer({size:i,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(c.getMappedRange()).set(l),c.unmap()}return c}async function Qn(r,e){let t=r.createShaderModule({code:e}),{messages:n}=await t.getCompilationInfo(),s=n.find(({type:i})=>i==="error");if(s)throw new Error(`a shader does not compile, line ${s.lineNum}: ${s.message}`);return t}var hn=(r,e,t,n)=>Oe(r,e.getBindGroupLayout(t),n);function Re(r,e){let t=Object.entries(e).map(([n,s])=>({binding:Number(n),visibility:GPUShaderStage.COMPUTE,buffer:{type:s}}));return r.createBindGroupLayout({entries:t})}function Oe(r,e,t){let n=Object.entries(t).map(([s,i])=>({binding:Number(s),resource:{buffer:i}}));return r.createBindGroup({layout:e,entries:n})}function ue(r,e,t,n){let s=Math.max(1,Math.ceil(n/64)),i=Math.min(s,32768);r.setPipeline(e),t.forEach((o,c)=>r.setBindGroup(c,o)),r.dispatchWorkgroups(i,Math.ceil(s/i))}async function pn(r,e,t){let n=r.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),s=r.createCommandEncoder();s.copyBufferToBuffer(e,0,n,0,n.size),r.queue.submit([s.finish()]),await n.mapAsync(GPUMapMode.READ);let i=n.getMappedRange().slice(0);return n.destroy(),i}var xu={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function _o(r,e,t,n,s=!0){let i=r.parts[e][t],{device:o,queue:c,bandPixels:l}=r,f=t==="transport"?2:1,h=n.length/16,d=new Float32Array(3*f*h);for(let g=0;g<h;g+=l){let w=Math.min(l,h-g);if(o.queue.writeBuffer(c.rows,0,n,16*g,16*w),o.queue.writeBuffer(c.count,0,Uint32Array.of(w)),r._run(S=>i.run(S,c,w)),await r.done(),!s)continue;let k=new Float32Array(await pn(o,c.answers,16*f*w));for(let S=0;S<f*w;S++)d.set(k.subarray(4*S,4*S+3),3*(f*g+S))}return d}async function vo(r,e,t,n){let{device:s,band:i}=r,{words:o,members:c}=ge.Pixel,l=new Uint32Array(o*e.length);e.forEach(({place:h,b1:d,b2:g,x:w,wi:k,part:S},L)=>{let Z=(G,W)=>[...new Uint32Array(Float32Array.from(G).buffer),W];l.set(ae("Pixel",{position:Z(w,0),axis:[0,0,0,S+1],wo:[0,0,0,h],wi:Z(k,0),b1:d,b2:g}),o*L)}),r.resize(e.length,1),r.span={first:0,pixels:e.length,jitter:0},s.queue.writeBuffer(i,0,l),r._writeFrame(xu,0),r._writeView({kind:"given",colour:[1,1,1]}),r._run(h=>ue(h,t,r.groups.rays,e.length));let f=new Float32Array(await pn(s,i,l.byteLength));return Float32Array.from({length:3*e.length},(h,d)=>f[o*Math.floor(d/3)+c[n].at+d%3])}var yo=(r,e)=>vo(r,e,r.kernels.light,"visibility");async function wo(r,e){let t=await r.pipelines.get(r.raySources.hit,"find_normals",r.rayLayout);return vo(r,e,t,"axis")}var hs=r=>Uint8Array.from(atob(r),e=>e.charCodeAt(0));function ps(r){let e=new Uint8Array(r.buffer,r.byteOffset,r.byteLength),t="";for(let n=0;n<e.length;n+=8192)t+=String.fromCharCode(...e.subarray(n,n+8192));return btoa(t)}var er=class{constructor(e){this.engine=e}async load(e,t){let n=await Dt.open(new bt(new Blob([hs(e)]),"package"));this.shown=await n.load(t),this.arrays=Bn(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,n){let s=t==="transport"?13:10,i=new Float32Array(hs(n).buffer),o=new Float32Array(16*i.length/s);for(let c=0;16*c<o.length;c++){let l=i.subarray(s*c,s*(c+1)),f=l.subarray(7,10);o.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...f,0,...s===13?l.subarray(10):f],16*c)}return ps(await this.answer(e,t,o))}answer(...e){return _o(this.engine,...e)}async visibility(e){return ps(await yo(this.engine,this._hits(e)))}async normals(e){return ps(await wo(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=hs(e),n=new Uint32Array(t),s=new Float32Array(t),i=[];for(let o=0;o<n.length;o+=8){let c=n[o+7],{first:l,fiber:f}=this.arrays.parts[c],h=s.subarray(o,o+7),d=this.arrays.where[l+n[o]];i.push(f?{place:d,part:c,b1:0,b2:0,x:h.slice(1,4),wi:h.slice(4,7)}:{place:d,part:c,b1:h[1],b2:h[2],x:[0,0,0],wi:h.slice(3,6)})}return i}};var Ht=.4*Math.PI/180,$t=5*Math.PI/180;function xo(r,e,t=()=>!0){let n=new Map,s=null;r.addEventListener("pointerdown",o=>{t(o)&&(n.set(o.pointerId,{x:o.clientX,y:o.clientY}),bu(r,o.pointerId),r.classList.add("dragging"),n.size===2?s="two":n.size===1&&(s=o.button===2?"pan":o.button!==0?null:o.altKey||o.shiftKey?"light":"orbit"))}),r.addEventListener("pointermove",o=>{let c=n.get(o.pointerId);if(!c)return;let l={x:o.clientX,y:o.clientY},f=l.x-c.x,h=l.y-c.y;s==="two"&&Au(n,o.pointerId,c,l,e),n.set(o.pointerId,l),!(!f&&!h)&&(s==="orbit"&&e.orbit(-f*Ht,h*Ht,!0),s==="light"&&e.light(f*Ht,-h*Ht,!0),s==="pan"&&e.pan(-f/r.clientHeight,h/r.clientHeight,!0))});for(let o of["pointerup","pointercancel"])r.addEventListener(o,c=>{n.delete(c.pointerId)&&(n.size||(s=null,r.classList.remove("dragging"),e.settle()))});r.addEventListener("contextmenu",o=>t(o)&&o.preventDefault()),r.addEventListener("dblclick",o=>t(o)&&e.reset());let i=0;r.addEventListener("wheel",o=>{if(!t(o))return;o.preventDefault();let c=o.deltaMode===0?o.deltaY:o.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,c))*.0012),!0),clearTimeout(i),i=setTimeout(()=>e.settle(),200)},{passive:!1}),r.addEventListener("keydown",o=>t(o)&&Eu(o,e))}function bu(r,e){try{r.setPointerCapture(e)}catch{}}function Au(r,e,t,n,s){let i=[...r].find(([c])=>c!==e)?.[1];if(!i)return;let o=c=>Math.hypot(c.x-i.x,c.y-i.y)||1;s.zoom(o(t)/o(n),!0),s.light(.5*(n.x-t.x)*Ht,-.5*(n.y-t.y)*Ht,!0)}function Eu(r,e){if(r.ctrlKey||r.metaKey)return;let t=r.altKey||r.shiftKey?e.light:e.orbit,n={ArrowLeft:()=>t(-$t,0),ArrowRight:()=>t($t,0),ArrowUp:()=>t(0,$t),ArrowDown:()=>t(0,-$t),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),"[":()=>e.light(-$t,0),"]":()=>e.light($t,0),Home:()=>e.reset()};Object.hasOwn(n,r.key)&&(r.preventDefault(),n[r.key]())}var{RNA_NONE:ko,MAX_LAYERS:bo,MAX_EXACT_INPUTS:Ao,RNA_CHANNEL_GROUPS:Eo}=ce,Bt=r=>Math.ceil(r/4);function nr(r,e,t,n=0){Ru(e);let{places:s,slots:i,queryGroups:o}=ku(t,r.planes.channels,n),c=new ds,l=ko;e.int8&&(l=c.add(tr(e.gain,s,o)),c.add(tr(e.offset,s,o)));let f=e.layers.map((k,S)=>{let L=+(!e.int8&&S+1<e.layers.length);return Ro(c,{...k,relu:L},S?null:s,S?0:o)}),h=null;if(e.matrix){let k=e.matrix.length/e.outputs,S=new Float32Array(e.outputs);h=Ro(c,{weight:e.matrix,bias:S,rows:k,columns:e.outputs,relu:0},null,0)}let d=[...f,...h?[h]:[]],g=Math.max(...d.flatMap(({inputs:k,outputs:S})=>[k,S])),w=Su(r,e,{queryGroups:o,gain:l,slots:i,layers:f,matrix:h});return{weights:c.all(),record:w,groups:Math.max(4,2**Math.ceil(Math.log2(g)))}}function Ru({layers:r,int8:e}){if(r.length>bo)throw new B(`a decoder of ${r.length} layers; at most ${bo}`);let t=e?Math.max(...r.map(({rows:n})=>n)):0;if(t>Ao)throw new B(`an int8 layer of ${t} inputs; at most ${Ao}`)}function ku(r,e,t){let n=[],s=Wn.map(()=>ko),i=0;for(let o of r){let c=Xn(o,e);s[Wn.indexOf(ft(o))]=i;for(let l=0;l<c;l++)n.push(4*i+l);i+=Bt(c)}for(let o=0;o<t;o++)n.push(4*i+o);return i+=Bt(t),{places:n,slots:s,queryGroups:i}}var ds=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let n of this.list)e.set(n,t),t+=n.length;return e}};function tr(r,e,t){let n=new Float32Array(4*t);return r.forEach((s,i)=>{n[e?e[i]:i]=s}),n}function Ro(r,{weight:e,bias:t,rows:n,columns:s,step:i=0,scales:o,relu:c},l,f){let h=f||Bt(n),d=Bt(s),g=new Float32Array(16*h*d);for(let L=0;L<n;L++){let Z=l?l[L]:L,G=Z>>2;for(let W=0;W<s;W++)g[16*((W>>2)*h+G)+4*(Z&3)+(W&3)]=e[L*s+W]}let w=r.add(g),k=r.add(tr(t,null,d)),S=o?r.add(tr(Float32Array.from(o,L=>L*i),null,d)):0;return{inputs:h,outputs:d,weights:w,bias:k,units:S,relu:c,int8_step:i}}function Su(r,e,{queryGroups:t,gain:n,slots:s,layers:i,matrix:o}){let{resolution:c,channels:l,precision:f,scales:h}=r.planes,{low:d,high:g,top:w,unit:k}=e,S=new Float32Array(12*Eo);for(let L=0;h&&L<3;L++)S.set(h.subarray(L*l,(L+1)*l),4*Eo*L);return ae("RnaPart",{low:r.bounds.min,high:r.bounds.max,resolution:c,channel_groups:Bt(l),query_groups:t,layer_count:i.length,plane_precision:ce[`RNA_${f.toUpperCase()}`],gain:n,query_low:d,query_high:g,top:w,unit:k,matrix:o??{},scales:S,layers:i,slots:s})}function So({values:r,resolution:e,channels:t},n){let s=e*e,i=r.subarray(n*s*t,(n+1)*s*t),o=4*Bt(t);if(o===t)return i;let c=new r.constructor(s*o);for(let l=0;l<s;l++)c.set(i.subarray(l*t,(l+1)*t),l*o);return c}var dt={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["row_records.wgsl","arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/lobe_constants.wgsl"],columns:["geometry_records.wgsl","queue"],queue:["row_records.wgsl","render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},ot={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
// by their bits, since WGSL may assume that there is no NaN, and may take subnormal numbers for 0.

const RNA_EXPONENT: u32 = 0x7f800000u;

fn rna_is_finite(bits: vec4<u32>) -> bool {
    return all((bits & vec4<u32>(RNA_EXPONENT)) != vec4<u32>(RNA_EXPONENT));
}

// A component, divided by 2^(largest - 127); of a subnormal largest 0, by 2^-149.
fn rna_scaled(bits: u32, largest: u32) -> f32 {
    let exponent = (bits & RNA_EXPONENT) >> 23u;
    let mantissa = f32(bits & 0x7fffffu);
    var size = 0.0;
    if largest == 0u {
        size = mantissa;
    } else if exponent != 0u {
        let down = largest - exponent;
        if down < 64u {
            size = bitcast<f32>(((127u - down) << 23u) | (bits & 0x7fffffu));
        }
    } else if largest < 64u {
        size = mantissa * bitcast<f32>((105u - largest) << 23u);
    }
    return select(size, -size, (bits >> 31u) == 1u);
}

// The unit vector along one of any length; 0 of length 0.
fn rna_unit(bits: vec3<u32>) -> vec3f {
    let exponents = (bits & vec3<u32>(RNA_EXPONENT)) >> vec3<u32>(23u);
    let largest = max(exponents.x, max(exponents.y, exponents.z));
    let v = vec3f(
        rna_scaled(bits.x, largest), rna_scaled(bits.y, largest), rna_scaled(bits.z, largest),
    );
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
`,"blocks.wgsl":`// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
// a group of 4 columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// Writes \`features\`, \`position\`, \`wo\` and \`wi\`; returns the first three features.
fn rna_common_blocks(x: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let p = rna_relative(x);
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, \`instead\` where they are opposite ("In float32": the difference of
// their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f, instead: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return instead;
    }
    return s / size;
}
`,"bvh.wgsl":`// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they call
//     fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool
// which opaque.wgsl answers, or a host that knows what lets light through; found: (t, b1, b2).

// Nodes to come back to: of the tree over instances, then of a body's. Private, since a function's own
// array would be set to 0 at every call.
var<private> rna_stack: array<u32, 2u * RNA_STACK>;

fn rna_inverse(d: vec3f) -> vec3f {
    let tiny = select(vec3f(1e-20), vec3f(-1e-20), d < vec3f(0.0));
    return vec3f(1.0) / select(d, tiny, abs(d) < vec3f(1e-20));
}

// Where the ray enters a node's box; RNA_FAR where it does not.
fn rna_enter_node(node: u32, origin: vec3f, inverse: vec3f, near: f32, far: f32) -> f32 {
    let a = (rna_nodes[node].low - origin) * inverse;
    let b = (rna_nodes[node].high - origin) * inverse;
    let lower = min(a, b);
    let upper = max(a, b);
    let enter = max(max(lower.x, lower.y), max(lower.z, near));
    let leave = min(min(upper.x, upper.y), min(upper.z, far));
    return select(RNA_FAR, enter, enter <= leave * 1.0000005);
}

// The next node down, nearer child first; RNA_NOTHING where none is hit.
fn rna_descend(
    node: u32, ray: RnaRay, inverse: vec3f, far: f32, top: ptr<function, u32>,
) -> u32 {
    let left = node + 1u;
    let right = rna_nodes[node].child;
    let to_left = rna_enter_node(left, ray.origin, inverse, ray.near, far);
    let to_right = rna_enter_node(right, ray.origin, inverse, ray.near, far);
    if to_left >= RNA_FAR && to_right >= RNA_FAR {
        return RNA_NOTHING;
    }
    if to_left >= RNA_FAR {
        return right;
    }
    if to_right >= RNA_FAR {
        return left;
    }
    let left_first = to_left <= to_right;
    rna_stack[*top] = select(left, right, left_first);
    *top += 1u;
    return select(right, left, left_first);
}

// Tests a primitive; whether it is hit nearer than \`hit\`, which is then set to it.
fn rna_meet(primitive: u32, ray: RnaRay, own_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if !rna_is_segment(record) {
        let found = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if found.x >= RNA_FAR || !rna_stops(primitive, ray, found, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(found.x, (*hit).instance, primitive, found.y, found.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == own_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, 0.0, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below \`root\`, ray in its object space, nearer than \`hit\`; with \`any\`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, own_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var found = false;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_meet(first + k, ray, own_strand, hit) {
                found = true;
                if any {
                    return true;
                }
            }
        }
        if next == RNA_NOTHING {
            if top == RNA_STACK {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return found;
}

// Tests an instance, world ray; \`own\` is passed through, and so is what \`rays\` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, own: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == own || (rna_instances[instance].rays & rays) == 0u {
        return false;
    }
    let scale = rna_instances[instance].scale;
    let local = rna_to_object(ray, instance);
    var nearest = *hit;
    nearest.instance = instance;
    nearest.t = min((*hit).t / scale, RNA_FAR);
    if !rna_trace_body(rna_instances[instance].root, local, RNA_NOTHING, any, &nearest) {
        return false;
    }
    nearest.t *= scale;
    *hit = nearest;
    return true;
}

// The closest hit in the world, or with \`any\` some hit.
fn rna_trace(ray: RnaRay, own: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_trace_instance(first + k, ray, own, rays, any, &hit) && any {
                return hit;
            }
        }
        if next == RNA_NOTHING {
            if top == 0u {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return hit;
}
`,"decoder.wgsl":`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

struct RnaTransport {
    visible: vec3f, // of emission: what is emitted
    shadowed: vec3f,
}

// Clip, and gain and offset of an int8 decoder.
fn rna_prepare_queries() {
    for (var k = 0u; k < rna_part.query_groups; k++) {
        var x = clamp(rna_values[k], vec4f(rna_part.query_low), vec4f(rna_part.query_high));
        if rna_part.gain != RNA_NONE {
            x = x * rna_weight(rna_part.gain + k)
                + rna_weight(rna_part.gain + rna_part.query_groups + k);
        }
        rna_values[k] = x;
    }
}

// QuantizeLinear: whole numbers from 0 to 255, halves to even.
fn rna_quantize(layer: RnaLayer, source: u32) {
    for (var k = 0u; k < layer.inputs; k++) {
        let x = rna_values[source + k] / layer.int8_step;
        rna_values[source + k] = clamp(round(x), vec4f(0.0), vec4f(255.0));
    }
}

// What a group of columns adds to the sums of an output group, with its block at \`at\`.
fn rna_block(x: vec4f, at: u32) -> vec4f {
    return x.x * rna_weight(at) + x.y * rna_weight(at + 1u)
        + x.z * rna_weight(at + 2u) + x.w * rna_weight(at + 3u);
}

fn rna_finish(layer: RnaLayer, o: u32, sums: vec4f, place: u32) {
    var y = sums + rna_weight(layer.bias + o);
    if layer.int8_step != 0.0 {
        y *= rna_weight(layer.units + o);
    }
    if layer.relu == 1u {
        y = max(y, vec4f(0.0));
    }
    rna_values[place + o] = y;
}

// Four output groups at a time: a value is read once for 16 sums. Sums of int8 layers are whole
// and below 2^24: exact.
fn rna_run_layer(layer: RnaLayer, source: u32, place: u32) {
    if layer.int8_step != 0.0 {
        rna_quantize(layer, source);
    }
    let stride = 4u * layer.inputs;
    var o = 0u;
    for (; o + 4u <= layer.outputs; o += 4u) {
        var a = vec4f(0.0);
        var b = vec4f(0.0);
        var c = vec4f(0.0);
        var d = vec4f(0.0);
        var at = layer.weights + o * stride;
        for (var k = 0u; k < layer.inputs; k++) {
            let x = rna_values[source + k];
            a += rna_block(x, at);
            b += rna_block(x, at + stride);
            c += rna_block(x, at + 2u * stride);
            d += rna_block(x, at + 3u * stride);
            at += 4u;
        }
        rna_finish(layer, o, a, place);
        rna_finish(layer, o + 1u, b, place);
        rna_finish(layer, o + 2u, c, place);
        rna_finish(layer, o + 3u, d, place);
    }
    for (; o < layer.outputs; o++) {
        var sums = vec4f(0.0);
        for (var k = 0u; k < layer.inputs; k++) {
            sums += rna_block(rna_values[source + k], layer.weights + o * stride + 4u * k);
        }
        rna_finish(layer, o, sums, place);
    }
}

// What the last layer gives, clipped, as radiance.
fn rna_expand(source: u32) {
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
}

// The place of the results in rna_values, from the queries there.
fn rna_run_decoder() -> u32 {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k <= rna_part.layer_count; k++) {
        var layer = rna_part.matrix;
        if k < rna_part.layer_count {
            layer = rna_part.layers[k];
        } else {
            rna_expand(source);
        }
        if layer.inputs == 0u {
            break; // there is no matrix
        }
        rna_run_layer(layer, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    return source;
}

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    let source = rna_run_decoder();
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
}
`,"environment_lobes.wgsl":`// Lobes of the transport for light from whole environments: spec/RNA.md, 12, RNA_environment. Whoever composes the files
// declares RNA_LOBES, RNA_IS_FIBER (1 or 0) and RNA_VISIBILITY_GROUPS: 4, or 0 of parts without harmonics.

const RNA_AXIS_SHIFT: f32 = 8.0;
const RNA_LEAST_KAPPA: f32 = 0.01;
const RNA_WIDE: f32 = 2.0; // kappa of a lobe that the decoder leaves as it is, of the first half
const RNA_SHARP: f32 = 10.0; // and of the rest

struct RnaLobe {
    amplitude: vec3f,
    kappa: f32,
    axis: vec3f, // its length is kappa, but for those below RNA_LEAST_KAPPA
}

// Runs the decoder. m: the mirror direction. visibility: harmonics of the asset's own, coefficients. The result is where
// rna_lobe finds its values.
fn rna_run_lobes(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, m: vec3f, visibility: array<vec4f, 4>,
) -> u32 {
    rna_put_queries(x, axis, h, wo, m);
    let first = rna_part.query_groups - RNA_VISIBILITY_GROUPS;
    for (var k = 0u; k < RNA_VISIBILITY_GROUPS; k++) {
        rna_values[first + k] = visibility[k];
    }
    return rna_run_decoder();
}

fn rna_three(place: u32, k: u32) -> vec3f {
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return max(vec3f(x, y, z), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), free);
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// RNA_COLOURS, 2 of transport and 1 of emission, is declared by whoever composes the files.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_COLOURS * row] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[2u * row + 1u] = vec4f(result.shadowed, 0.0);
    }
}

@compute @workgroup_size(64)
fn rna_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= rna_row_count[0] {
        return;
    }
    let at = rna_rows[row];
    let finite = rna_is_finite(vec4<u32>(at.position, at.h)) && rna_is_finite(vec4<u32>(at.axis, 0u))
        && rna_is_finite(vec4<u32>(at.wo, 0u)) && rna_is_finite(vec4<u32>(at.wi, 0u));
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi);
}
`,"fiber_blocks.wgsl":`// Input blocks of fibers alone: spec/RNA.md, 6.3 Input blocks and "In float32".

const RNA_ETA: f32 = 1.55;

// c_o, cos phi and sin phi. Products with t have lost the component along it: t x wo and t x wi
// have the lengths c_o and c_i, and phi is between them.
fn rna_azimuth(t: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let o = cross(t, wo);
    let i = cross(t, wi);
    let c_o = length(o);
    let d = c_o * length(i);
    if d < 1e-6 {
        return vec3f(c_o, 1.0, 0.0);
    }
    return vec3f(c_o, clamp(dot(o, i) / d, -1.0, 1.0), clamp(dot(t, cross(o, i)) / d, -1.0, 1.0));
}

// Cosine and sine of twice the angle within 90 degrees that has this sine.
fn rna_doubled(sine: f32) -> vec2f {
    let cosine = sqrt(max(0.0, (1.0 - sine) * (1.0 + sine)));
    return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * cosine);
}

// cos(phi - Phi_p) for p = 0, 1, 2, by the addition theorems; each segment turns by -2 g_t - pi.
fn rna_lobes(h: f32, s_o: f32, azimuth: vec3f) -> vec3f {
    let segment = rna_doubled(h * azimuth.x / sqrt(RNA_ETA * RNA_ETA - s_o * s_o));
    let r = rna_doubled(h);
    let tt = vec2f(-r.x * segment.x - r.y * segment.y, r.x * segment.y - r.y * segment.x);
    let trt = vec2f(-tt.x * segment.x - tt.y * segment.y, tt.x * segment.y - tt.y * segment.x);
    let phi = azimuth.yz;
    return vec3f(dot(phi, r), dot(phi, tt), dot(phi, trt));
}

fn rna_fiber_blocks(t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_TANGENT), vec4f(t, 0.0));
    rna_put(rna_slot(RNA_BLOCK_H), vec4f(h, 0.0, 0.0, 0.0));
    let angles = rna_slot(RNA_BLOCK_FIBER_ANGLES);
    let lobes = rna_slot(RNA_BLOCK_FIBER_LOBES);
    if angles == RNA_NONE && lobes == RNA_NONE {
        return;
    }
    let s_o = dot(t, wo);
    let s_i = dot(t, wi);
    let cone = s_i + s_o;
    let azimuth = rna_azimuth(t, wo, wi);
    if angles != RNA_NONE {
        rna_values[angles] = vec4f(s_i, s_o, cone, log2(cone * cone + 1e-3) / 6.0);
        rna_values[angles + 1u] = vec4f(azimuth.yz, 0.0, 0.0);
    }
    rna_put(lobes, vec4f(rna_lobes(h, s_o, azimuth), 0.0));
}
`,"geometry.wgsl":`// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; instances place the bodies in the world. \`geometry.py\` fills them.

// The tree over instances comes first.
@group(2) @binding(0) var<storage, read> rna_nodes: array<RnaNode>;

@group(2) @binding(1) var<storage, read> rna_primitives: array<RnaPrimitive>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

@group(2) @binding(3) var<storage, read> rna_instances: array<RnaInstance>;

const RNA_FAR: f32 = 1e30;
const RNA_STACK: u32 = 48u;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct RnaHit {
    t: f32,
    instance: u32, // RNA_NOTHING for a miss
    primitive: u32,
    b1: f32, // barycentric coordinates of a triangle's second and third corner
    b2: f32,
    normal: vec3f, // outward, of a segment
}

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

fn rna_is_segment(primitive: RnaPrimitive) -> bool {
    return (primitive.tag & RNA_IS_SEGMENT) != 0u;
}

fn rna_surface(primitive: RnaPrimitive) -> u32 {
    return primitive.tag >> RNA_SURFACE_SHIFT;
}

// Of a segment.
fn rna_strand(primitive: RnaPrimitive) -> u32 {
    return primitive.c;
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let scale = rna_instances[instance].scale;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[instance].to_object[0], p),
        dot(rna_instances[instance].to_object[1], p),
        dot(rna_instances[instance].to_object[2], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    return d.x * rna_instances[instance].rotation[0].xyz
        + d.y * rna_instances[instance].rotation[1].xyz
        + d.z * rna_instances[instance].rotation[2].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    return vec3f(
        dot(rna_instances[instance].rotation[0].xyz, d),
        dot(rna_instances[instance].rotation[1].xyz, d),
        dot(rna_instances[instance].rotation[2].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    return rna_instances[instance].scale * rna_world_direction(x, instance)
        + rna_instances[instance].place;
}
`,"geometry_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NOTHING: u32 = 0xffffffffu;
const RNA_IS_SEGMENT: u32 = 1u;
const RNA_SURFACE_SHIFT: u32 = 1u;
const RNA_HAS_BEFORE: u32 = 1u;
const RNA_HAS_AFTER: u32 = 2u;

struct RnaNode { // 32 bytes
    low: vec3f, // 0
    child: u32, // 12; the right one, the left one is the next node; a leaf's first primitive
    high: vec3f, // 16
    count: u32, // 28; a leaf's primitives; 0 of inner nodes
}

struct RnaPrimitive { // 16 bytes
    a: u32, // 0; point: a triangle's first corner, a segment's start
    b: u32, // 4; second corner; of a segment RNA_HAS_BEFORE and RNA_HAS_AFTER
    c: u32, // 8; third corner; of a segment its strand
    tag: u32, // 12; surface << RNA_SURFACE_SHIFT, and RNA_IS_SEGMENT
}

struct RnaInstance { // 128 bytes
    to_object: array<vec4f, 3>, // 0; rows of the matrix
    rotation: array<vec4f, 3>, // 48; to the world: rows, the fourth column free
    place: vec3f, // 96; in the world
    scale: f32, // 108; to the world
    root: u32, // 112; node
    rays: u32, // 116; bits of those that can hit it
    extent: f32, // 120; largest coordinate of its body
    own: u32, // 124; a number of the host's
}
`,"normal_maps.wgsl":`// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// at modulo sides. Vulkan leaves \`%\` of a negative number undefined, and drivers differ.
fn rna_repeated(at: vec2<i32>, sides: vec2<i32>) -> vec2<i32> {
    let left = at - at / sides * sides;
    return select(left, left + sides, left < vec2<i32>(0));
}

// x and y of a map of \`size\` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let i = vec2<u32>(rna_repeated(vec2<i32>(low), sides));
    let j = vec2<u32>(rna_repeated(vec2<i32>(low) + 1, sides));
    let upper = mix(rna_map_texel(map, i.y, i.x), rna_map_texel(map, i.y, j.x), part.x);
    let lower = mix(rna_map_texel(map, j.y, i.x), rna_map_texel(map, j.y, j.x), part.x);
    return (mix(upper, lower, part.y) - 127.0) / 127.0;
}

// n: interpolated normal; p: corners; uv: their texture coordinates; b: barycentric coordinates.
fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = sign(area);
    let along_u = (d2.y * e1 - d1.y * e2) * side;
    let along_v = (d1.x * e2 - d2.x * e1) * side;
    let t = along_u - dot(along_u, n) * n;
    if area == 0.0 || length(t) <= 1e-6 * length(along_u) {
        return n;
    }
    let tangent = normalize(t);
    var bitangent = cross(n, tangent);
    if dot(bitangent, along_v) > 0.0 {
        bitangent = -bitangent;
    }
    let xy = rna_map_value(map, size, uv * b);
    let z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
    let m = xy.x * tangent + xy.y * bitangent + z * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}
`,"part.wgsl":`// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
`,"part_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NONE: u32 = 0xffffffffu;
const RNA_FLOAT32: u32 = 0u;
const RNA_FLOAT16: u32 = 1u;
const RNA_INT8: u32 = 2u;
const RNA_BLOCK_FEATURES: u32 = 0u;
const RNA_BLOCK_POSITION: u32 = 1u;
const RNA_BLOCK_NORMAL: u32 = 2u;
const RNA_BLOCK_TANGENT: u32 = 3u;
const RNA_BLOCK_H: u32 = 4u;
const RNA_BLOCK_WO: u32 = 5u;
const RNA_BLOCK_WI: u32 = 6u;
const RNA_BLOCK_HALF_VECTOR: u32 = 7u;
const RNA_BLOCK_HIGHLIGHT: u32 = 8u;
const RNA_BLOCK_LEARNED_NORMAL: u32 = 9u;
const RNA_BLOCK_FIBER_ANGLES: u32 = 10u;
const RNA_BLOCK_FIBER_LOBES: u32 = 11u;
const RNA_CHANNEL_GROUPS: u32 = 16u;

struct RnaLayer { // 32 bytes
    inputs: u32, // 0; groups of 4 columns
    outputs: u32, // 4
    weights: u32, // 8; place of [outputs][inputs][4] vec4f
    bias: u32, // 12; place of [outputs] vec4f
    units: u32, // 16; place of [outputs] vec4f of an int8 layer: what a sum of 1 means
    relu: u32, // 20; 1: negative results are 0
    int8_step: f32, // 24; of an int8 layer: what 1 means in its inputs; else 0
    reserved: u32, // 28
}

struct RnaPart { // 1936 bytes
    low: vec3f, // 0; smallest corner of the bounds
    resolution: u32, // 12
    high: vec3f, // 16
    channel_groups: u32, // 28; channels / 4, rounded up
    query_groups: u32, // 32; of the decoder's input
    layer_count: u32, // 36
    plane_precision: u32, // 40; RNA_FLOAT32, RNA_FLOAT16 or RNA_INT8
    gain: u32, // 44; place of [query_groups] gains, then the offsets; RNA_NONE without
    query_low: f32, // 48; the decoder's first Clip
    query_high: f32, // 52
    top: f32, // 56; of the Clip before Exp
    unit: f32, // 60; result = (exp(x) - 1) unit, or times the matrix; then 1
    matrix: RnaLayer, // 64; [n, 6], with a bias of 0; all 0 without
    scales: array<vec4f, 48>, // 96; of int8 planes, [plane][group]
    layers: array<RnaLayer, 32>, // 864
    slots: array<vec4<u32>, 3>, // 1888; first group of each block, RNA_NONE for none: see rna_slot
}
`,"planes.wgsl":`// Features of a position: spec/RNA.md, 5 Planes.

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}

// The value of a float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: u32) -> f32 {
    let exponent = (bits >> 10u) & 31u;
    let mantissa = bits & 1023u;
    let size = select(
        bitcast<f32>(((exponent + 112u) << 23u) | (mantissa << 13u)),
        f32(mantissa) * 0x1p-24f,
        exponent == 0u,
    );
    return select(size, -size, (bits & 0x8000u) != 0u);
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let at = texel * rna_part.channel_groups + group;
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return vec4f(
                bitcast<f32>(rna_plane_word(plane, 4u * at)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 1u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 2u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 3u)),
            );
        }
        case RNA_FLOAT16: {
            let a = rna_plane_word(plane, 2u * at);
            let b = rna_plane_word(plane, 2u * at + 1u);
            return vec4f(
                rna_from_float16(a & 0xffffu),
                rna_from_float16(a >> 16u),
                rna_from_float16(b & 0xffffu),
                rna_from_float16(b >> 16u),
            );
        }
        default: {
            let word = bitcast<i32>(rna_plane_word(plane, at));
            let integers = vec4<i32>(word << 24u, word << 16u, word << 8u, word) >> vec4<u32>(24u);
            return vec4f(integers) * rna_part.scales[plane * RNA_CHANNEL_GROUPS + group];
        }
    }
}

// Where a position is on one axis: texel, the next one, and the fraction between them.
struct RnaTexel {
    low: vec3<u32>,
    high: vec3<u32>,
    fraction: vec3f,
}

fn rna_texels(p: vec3f) -> RnaTexel {
    let last = f32(rna_part.resolution - 1u);
    let s = clamp(p * f32(rna_part.resolution) - 0.5, vec3f(0.0), vec3f(last));
    let below = floor(s);
    let low = vec3<u32>(below);
    let high = min(low + vec3<u32>(1u), vec3<u32>(rna_part.resolution - 1u));
    return RnaTexel(low, high, s - below);
}

// x: (texel, next) along the columns, y: along the rows.
fn rna_bilinear(
    plane: u32, group: u32, columns: vec2<u32>, rows: vec2<u32>, a: f32, b: f32,
) -> vec4f {
    let lower = rows.x * rna_part.resolution;
    let upper = rows.y * rna_part.resolution;
    let at_lower = (1.0 - a) * rna_texel(plane, lower + columns.x, group)
        + a * rna_texel(plane, lower + columns.y, group);
    let at_upper = (1.0 - a) * rna_texel(plane, upper + columns.x, group)
        + a * rna_texel(plane, upper + columns.y, group);
    return (1.0 - b) * at_lower + b * at_upper;
}

// Position as a fraction of the bounds, clamped to them.
fn rna_relative(x: vec3f) -> vec3f {
    let inside = clamp(x, rna_part.low, rna_part.high);
    return clamp((inside - rna_part.low) / (rna_part.high - rna_part.low), vec3f(0.0), vec3f(1.0));
}

// Channels 4 group to 4 group + 3 of the features at p, in [0, 1].
fn rna_features(t: RnaTexel, group: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var plane = 0u; plane < 3u; plane++) {
        let next = (plane + 1u) % 3u;
        let columns = vec2<u32>(t.low[plane], t.high[plane]);
        let rows = vec2<u32>(t.low[next], t.high[next]);
        sum += rna_bilinear(plane, group, columns, rows, t.fraction[plane], t.fraction[next]);
    }
    return sum;
}
`,"render/bumps.wgsl":`// Normals of materials with the relief of a normal texture: rna_render/materials/bumps.py.

const MIN_MIRROR_COSINE: f32 = 0.01;

fn unit_or_zero(v: vec3f) -> vec3f {
    let size = length(v);
    return select(vec3f(0.0), v / max(size, 1e-30), size > 0.0);
}

fn point_tangent(base: u32, point: u32) -> vec4f {
    let at = base + 4u * point;
    return bitcast<vec4f>(vec4<u32>(images[at], images[at + 1u], images[at + 2u], images[at + 3u]));
}

// The file's tangent, interpolated, and the bitangent's sign; a sign of 0 where a corner has none.
fn given_tangent(record: RnaPrimitive, b: vec3f) -> vec4f {
    let base = surface_tangents(rna_surface(record));
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.a);
    let second = point_tangent(base, record.b);
    let third = point_tangent(base, record.c);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: RnaPrimitive, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = select(1.0, -1.0, area < 0.0);
    let along_u = side * (d2.y * e1 - d1.y * e2);
    let along_v = side * (d1.x * e2 - d2.x * e1);
    let sign = select(1.0, -1.0, dot(cross(n, along_u), along_v) > 0.0);
    return vec4f(along_u, select(0.0, sign, area != 0.0));
}

// m, or the nearest normal that mirrors o above the surface; g is on o's side.
fn kept_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: RnaPrimitive, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(rna_surface(record), RELIEF);
    if texture == NONE {
        return m;
    }
    let uvs = corner_uvs(record, (image_of(texture).form >> 5u) & 1u);
    let b = weights_of(b1, b2);
    var tangent = given_tangent(record, b);
    if tangent.w == 0.0 {
        tangent = derived_tangent(record, uvs, m);
    }
    let t = unit_or_zero(tangent.xyz - dot(tangent.xyz, m) * m);
    if tangent.w == 0.0 || dot(t, t) == 0.0 {
        return m;
    }
    let scale = surface_normal_scale(rna_surface(record));
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let own = select(-side, side, dot(m, g) >= 0.0);
    return own * kept_above(own * bent, side * g, o);
}
`,"render/directions.wgsl":`// Directions about an axis.

const SPHERE_PDF: f32 = 1.0 / (4.0 * PI);

struct Tangents {
    s: vec3f,
    t: vec3f,
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
fn tangents_of(n: vec3f) -> Tangents {
    let sign = select(1.0, -1.0, n.z < 0.0);
    let c = -1.0 / (sign + n.z);
    let d = n.x * n.y * c;
    return Tangents(
        vec3f(1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x),
        vec3f(d, sign + n.y * n.y * c, -n.y),
    );
}

fn about(axis: vec3f, sine: f32, cosine: f32, turns: f32) -> vec3f {
    let frame_of = tangents_of(axis);
    let phi = 2.0 * PI * turns;
    return sine * cos(phi) * frame_of.s + sine * sin(phi) * frame_of.t + cosine * axis;
}

fn along_axis(axis: vec3f, cosine: f32, turns: f32) -> vec3f {
    return about(axis, sqrt(max(0.0, 1.0 - cosine * cosine)), cosine, turns);
}

// Cosine to the axis of a von Mises-Fisher direction.
fn fisher_cosine(u: f32, kappa: f32) -> f32 {
    return max(-1.0, 1.0 + log(u + (1.0 - u) * exp(-2.0 * kappa)) / kappa);
}

fn fisher_pdf(cosine: f32, kappa: f32) -> f32 {
    return kappa * exp(kappa * (cosine - 1.0)) / (2.0 * PI * (1.0 - exp(-2.0 * kappa)));
}

// Uniform within a cone about a unit axis, by 1 - cos of the angle to its rim.
fn cone_direction(axis: vec3f, one_minus_cosine: f32, u: vec2f) -> vec3f {
    let height = u.x * one_minus_cosine;
    return about(axis, sqrt(max(0.0, height * (2.0 - height))), 1.0 - height, u.y);
}
`,"render/environment.wgsl":`// An equirectangular image: see rna_render/lights/equirectangular.py and image_kernels.py, which this follows. In \`images\`
// a light has texels (h, w, 3), heights (h + 1), running sums of rows (h + 2) and of each row's cells
// (h + 1, w + 1).

struct Cell {
    corners: mat4x3f,
    luminances: vec4f,
}

fn image_float(at: u32) -> f32 {
    return bitcast<f32>(images[at]);
}

fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

fn image_size(light: u32) -> vec2<u32> {
    return vec2<u32>(u32(image_rows(light)), u32(image_columns(light)));
}

fn image_texel(light: u32, row: u32, column: u32) -> vec3f {
    let at = image_texels(light) + 3u * (row * image_size(light).y + column);
    return vec3f(image_float(at), image_float(at + 1u), image_float(at + 2u));
}

fn image_cell(light: u32, row: u32, column: u32) -> Cell {
    let size = image_size(light);
    let upper = max(row, 1u) - 1u;
    let lower = min(row, size.x - 1u);
    let right = select(0u, column + 1u, column + 1u < size.y);
    let a = image_texel(light, upper, column);
    let b = image_texel(light, upper, right);
    let c = image_texel(light, lower, column);
    let d = image_texel(light, lower, right);
    return Cell(
        mat4x3f(a, b, c, d), vec4f(luminance(a), luminance(b), luminance(c), luminance(d)),
    );
}

fn in_cell(cell: Cell, x: f32, y: f32) -> vec3f {
    return cell.corners * vec4f((1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y);
}

// The interval of running sums from \`at\` on, \`count\` of them, that a value is in, by bisection.
fn interval(at: u32, count: u32, value: f32) -> u32 {
    var low = 0u;
    var high = count;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if image_float(at + middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn place_within(at: u32, k: u32, value: f32) -> f32 {
    let size = image_float(at + k + 1u) - image_float(at + k);
    if size <= 0.0 {
        return 0.0;
    }
    return clamp((value - image_float(at + k)) / size, 0.0, 0.99999994);
}

// A place in [0, 1] with density in proportion to a line from a to b.
fn sample_linear(a: f32, b: f32, u: f32) -> f32 {
    let root = sqrt(max(a * a + u * (b * b - a * a), 0.0));
    if a + root <= 0.0 {
        return u;
    }
    return u * (a + b) / (a + root);
}

fn image_density(light: u32, row: u32, sine: f32, here: f32, mean_here: f32) -> f32 {
    let total = image_total(light);
    let mean = image_mean(light);
    if total <= 0.0 {
        return 0.0;
    }
    let size = image_size(light);
    var pdf = here * f32(size.y) / (2.0 * PI * total);
    if mean > 0.0 {
        pdf *= max(mean_here - mean, 0.0) / max(mean_here, 1e-30);
    }
    if row > 0u && row < size.x {
        let height = image_float(image_heights(light) + row);
        pdf *= height * f32(size.x) / (PI * max(sine, 1e-30));
    }
    return pdf;
}

// Where in a cell of that row, down from the middles above.
fn sample_down(light: u32, row: u32, l: vec4f, u: f32) -> f32 {
    let h = image_size(light).x;
    let height = image_float(image_heights(light) + row);
    let cap = 2.0 * asin(sqrt(u * height / 2.0)) / PI * f32(h);
    if row == 0u {
        return cap + 0.5;
    }
    if row == h {
        return 0.5 - cap;
    }
    return sample_linear(l.x + l.y, l.z + l.w, u);
}

fn sample_image(light: u32, u: vec2f) -> LightSample {
    let size = image_size(light);
    let rows = image_row_sums(light);
    let down = u.y * image_float(rows + size.x + 1u);
    let row = interval(rows, size.x + 1u, down);
    let columns = image_column_sums(light) + row * (size.y + 1u);
    let across = u.x * image_float(columns + size.y);
    let column = interval(columns, size.y, across);
    let cell = image_cell(light, row, column);
    let l = cell.luminances;
    let y = sample_down(light, row, l, place_within(rows, row, down));
    let left = mix(l.x, l.z, y);
    let x = sample_linear(left, mix(l.y, l.w, y), place_within(columns, column, across));
    let theta = PI * (f32(row) - 0.5 + y) / f32(size.x);
    let phi = 2.0 * PI * ((f32(column) + 0.5 + x) / f32(size.y) - 0.5);
    let sine = sin(theta);
    let away = sine * sin(phi);
    let along = -sine * cos(phi);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let wi = vec3f(turn.x * away + turn.y * along, cos(theta), turn.x * along - turn.y * away);
    let radiance = in_cell(cell, x, y);
    let pdf = image_density(light, row, sine, luminance(radiance), dot(l, vec4f(0.25)));
    return light_sample(wi, RNA_FAR, light_colour(light) * radiance, pdf);
}

fn look_up_image(light: u32, d: vec3f) -> LightHit {
    let size = image_size(light);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let x = turn.x * d.x - turn.y * d.z;
    let z = turn.y * d.x + turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    var azimuth = 0.0;
    if sine > 0.0 {
        azimuth = atan2(x, -z);
    }
    let s = (0.5 + azimuth / (2.0 * PI)) * f32(size.y) - 0.5;
    let t = atan2(sine, d.y) / PI * f32(size.x) + 0.5;
    let row = u32(clamp(floor(t), 0.0, f32(size.x)));
    let left = floor(s);
    let column = select(size.y - 1u, u32(max(left, 0.0)), left >= 0.0 && left < f32(size.y));
    let cell = image_cell(light, row, column);
    let radiance = in_cell(cell, s - left, t - f32(row));
    let mean = dot(cell.luminances, vec4f(0.25));
    let pdf = image_density(light, row, sine, luminance(radiance), mean);
    return LightHit(light_colour(light) * radiance, pdf);
}
`,"render/frame.wgsl":`// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> queries: array<PathQueries>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY] += vec4f(radiance, 0.0);
    let group = light_group(light);
    if group != NONE {
        sums[at + SUM_GROUPS + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Clamped after two or more scatterings.
fn clamped(radiance: vec3f) -> vec3f {
    if frame.clamp <= 0.0 || frame.depth < 2u {
        return radiance;
    }
    let largest = max(max(radiance.x, max(radiance.y, radiance.z)), 1e-30);
    return radiance * (min(frame.clamp, largest) / largest);
}

// Power heuristic: the part of the estimate that belongs to the first way.
fn share(pdf: f32, other: f32) -> f32 {
    if pdf <= 0.0 {
        return 0.0;
    }
    let ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
`,"render/light_shapes.wgsl":`// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    var hit = found;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = frame.rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
        let t = meet_light(light, RnaRay(ray.origin, ray.near, ray.direction, hit.t));
        if !hidden && t < RNA_FAR && (hit.instance == RNA_NOTHING || t < hit.t) {
            hit = rna_miss(t);
            hit.instance = IS_LIGHT | light;
        }
    }
    return hit;
}
`,"render/lights.wgsl":`// Lights: samples of them, and their radiance and density at hits of rays. They are those of rna_render.lights.

const MAX_PDF: f32 = 1e18;
const MIN_SOLID_ANGLE: f32 = 1e-3; // float32 knows no smaller one to 1e-3 of itself

struct LightSample {
    wi: vec3f,
    distance: f32,
    radiance: vec3f, // of an asset's triangles a factor on what they emit
    pdf: f32,
    primitive: u32, // of triangles
    b1: f32,
    b2: f32,
}

fn light_sample(wi: vec3f, distance: f32, radiance: vec3f, pdf: f32) -> LightSample {
    return LightSample(wi, distance, radiance, pdf, NONE, 0.0, 0.0);
}

// A light along a ray: its radiance, and the density of sampling it there.
struct LightHit {
    radiance: vec3f,
    pdf: f32,
}

// Samples that a light gets at a point, on average.
fn samples_of(light: u32, depth: u32) -> f32 {
    return light_probability(light)[min(depth, 3u) - 1u];
}

fn light_is(light: u32, flag: u32) -> bool {
    return (light_flags(light) & flag) != 0u;
}

// Of points of a plane: per_area, seen along d; 0 from behind.
fn flat_pdf(point: vec3f, normal: vec3f, per_area: f32, x: vec3f, d: vec3f) -> f32 {
    let cosine = -dot(d, normal);
    let height = dot(x - point, normal);
    if cosine <= 0.0 || height <= 0.0 {
        return 0.0;
    }
    let t = height / cosine;
    let pdf = per_area * t * t / cosine;
    return select(0.0, pdf, pdf < MAX_PDF);
}

fn edge_angle(x: f32, y: f32, sign: f32, height: f32) -> f32 {
    return atan2(height * sqrt(x * x + y * y + height * height), sign * x * y);
}

// Solid angle of a rectangle from (x0, y0) to (x1, y1), and the sum k of Ure\xF1a, Fajardo and King,
// An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013), section 5.
fn solid_angle(e: vec4f, height: f32) -> vec2f {
    let k = 2.0 * PI - edge_angle(e.x, e.w, 1.0, height) - edge_angle(e.x, e.z, -1.0, height);
    let right = edge_angle(e.y, e.z, 1.0, height) + edge_angle(e.y, e.w, -1.0, height);
    return vec2f(right - k, k);
}

// Edges x0, x1, y0, y1 of a rectangle as seen from x.
fn rectangle_edges(light: u32, from_place: vec3f) -> vec4f {
    let a = dot(from_place, rectangle_frame(light)[0]);
    let b = dot(from_place, rectangle_frame(light)[1]);
    let half = rectangle_half(light);
    return vec4f(-half.x - a, half.x - a, -half.y - b, half.y - b);
}

fn rectangle_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let half = rectangle_half(light);
    let f = rectangle_frame(light);
    let flat = flat_pdf(f[3], f[2], 0.25 / (half.x * half.y), x, d);
    let height = dot(x - f[3], f[2]);
    let angle = solid_angle(rectangle_edges(light, x - f[3]), max(height, 1e-30)).x;
    if flat == 0.0 || angle < MIN_SOLID_ANGLE {
        return flat;
    }
    return 1.0 / angle;
}

fn rectangle_point(e: vec4f, height: f32, u: vec2f) -> vec2f {
    let angle = solid_angle(e, height);
    if angle.x < MIN_SOLID_ANGLE {
        return mix(e.xz, e.yw, u);
    }
    let b0 = -e.z / sqrt(height * height + e.z * e.z);
    let b1 = e.w / sqrt(height * height + e.w * e.w);
    let turn = u.x * angle.x + angle.y;
    let sine = sin(turn);
    let f = (cos(turn) * b0 - b1) / select(sine, 1e-20, abs(sine) < 1e-20);
    let c = clamp(select(-1.0, 1.0, f >= 0.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    let x = clamp(c * height / sqrt(max(1.0 - c * c, 1e-20)), e.x, e.y);
    let squared = x * x + height * height;
    let h0 = e.z / sqrt(squared + e.z * e.z);
    let h1 = e.w / sqrt(squared + e.w * e.w);
    let h = h0 + u.y * (h1 - h0);
    let y = h * sqrt(squared / max(1.0 - h * h, 1e-20));
    return vec2f(x, clamp(y, e.z, e.w));
}

// Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
fn concentric(u: vec2f) -> vec2f {
    let a = 2.0 * u - 1.0;
    if a.x == 0.0 && a.y == 0.0 {
        return vec2f(0.0);
    }
    if abs(a.x) > abs(a.y) {
        let phi = PI / 4.0 * (a.y / a.x);
        return a.x * vec2f(cos(phi), sin(phi));
    }
    let phi = PI / 2.0 - PI / 4.0 * (a.x / a.y);
    return a.y * vec2f(cos(phi), sin(phi));
}

// 1 - cos of the angular radius of a sphere light; 0 from within.
fn sphere_cone(light: u32, x: vec3f) -> f32 {
    let to_centre = sphere_centre(light) - x;
    let radius = sphere_radius(light);
    let squared = dot(to_centre, to_centre);
    if squared <= radius * radius {
        return 0.0;
    }
    let sin2 = radius * radius / squared;
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}

fn shape_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        return rectangle_pdf(light, x, d);
    }
    if kind == DISK {
        let radius = disk_radius(light);
        let per_area = 1.0 / (PI * radius * radius);
        return flat_pdf(disk_frame(light)[3], disk_frame(light)[2], per_area, x, d);
    }
    let cone = sphere_cone(light, x);
    return select(0.0, 1.0 / (2.0 * PI * max(cone, 1e-18)), cone > 0.0);
}

// A point of a shape, relative to x.
fn shape_point(light: u32, x: vec3f, u: vec2f) -> vec3f {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        let f = rectangle_frame(light);
        let height = dot(x - f[3], f[2]);
        if height <= 0.0 {
            return f[3] - x;
        }
        let p = rectangle_point(rectangle_edges(light, x - f[3]), height, u);
        return p.x * f[0] + p.y * f[1] - height * f[2];
    }
    if kind == DISK {
        let f = disk_frame(light);
        let p = disk_radius(light) * concentric(u);
        return f[3] + p.x * f[0] + p.y * f[1] - x;
    }
    let to_centre = sphere_centre(light) - x;
    let wi = cone_direction(normalize(to_centre), sphere_cone(light, x), u);
    let along = dot(to_centre, wi);
    let rest = to_centre - along * wi;
    let radius = sphere_radius(light);
    return (along - sqrt(max(0.0, radius * radius - dot(rest, rest)))) * wi;
}

fn point_light(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, point_axis(light));
    let inner = point_cos_inner(light);
    let outer = point_cos_outer(light);
    var factor = 1.0;
    if cosine < inner {
        let t = clamp((cosine - outer) / max(inner - outer, 1e-20), 0.0, 1.0);
        factor = t * t * (3.0 - 2.0 * t);
    }
    let pdf = select(0.0, 1.0, factor > 0.0);
    return light_sample(wi, r, factor / (r * r) * light_colour(light), pdf);
}

fn sample_light(light: u32, x: vec3f, u: vec2f) -> LightSample {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return sample_image(light, u);
    }
    if kind == UNIFORM {
        return light_sample(
            cone_direction(vec3f(0.0, 0.0, 1.0), 2.0, u), RNA_FAR, colour, SPHERE_PDF,
        );
    }
    if kind == SUN {
        let cone = sun_one_minus_cosine(light);
        let wi = cone_direction(sun_axis(light), cone, u);
        return light_sample(wi, RNA_FAR, colour, 1.0 / (2.0 * PI * cone));
    }
    if kind == DIRECTIONAL {
        return light_sample(directional_axis(light), RNA_FAR, colour, 1.0);
    }
    if kind == TRIANGLES {
        return sample_triangles(light, x, u);
    }
    if kind == POINT {
        return point_light(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// An infinite light along d.
fn environment_along(light: u32, d: vec3f) -> LightHit {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return LightHit(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return LightHit(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return LightHit(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's position there, along the light's axes.
fn on_plane(f: mat4x3f, ray: RnaRay, t: f32) -> vec2f {
    let p = ray.origin + t * ray.direction - f[3];
    return vec2f(dot(p, f[0]), dot(p, f[1]));
}

// Where a ray meets the shape of a light; RNA_FAR where it does not.
fn meet_light(light: u32, ray: RnaRay) -> f32 {
    let kind = light_kind(light);
    var t = RNA_FAR;
    if kind == SPHERE {
        let centre = sphere_centre(light);
        let radius = sphere_radius(light);
        t = rna_enter_sphere(ray.origin, ray.direction, centre, radius);
        let from_centre = ray.origin - centre;
        if dot(from_centre, from_centre) < radius * radius && t < RNA_FAR {
            t = -t - 2.0 * dot(from_centre, ray.direction);
        }
    } else if kind == RECTANGLE {
        let f = rectangle_frame(light);
        t = meet_plane(f, ray);
        let p = abs(on_plane(f, ray, t));
        t = select(RNA_FAR, t, all(p <= rectangle_half(light)));
    } else if kind == DISK {
        let f = disk_frame(light);
        t = meet_plane(f, ray);
        t = select(RNA_FAR, t, length(on_plane(f, ray, t)) <= disk_radius(light));
    }
    return select(RNA_FAR, t, t >= ray.near && t < ray.far);
}
`,"render/lobe_constants.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const SURFACE_SHARES = vec3f(0.2, 0.35, 0.45);
const FIBER_SHARES = vec3f(0.3, 0.45, 0.25);
const MIRROR_KAPPA: f32 = 20.0;
const CONE_SCALE: f32 = 0.06;
const FORWARD_KAPPA: f32 = 5.0;
`,"render/passing.wgsl":`// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed

var<private> passing: u32;
var<private> passed_weight: vec3f;
var<private> is_coloured: bool;
var<private> stopped_share: vec3f; // of the last hit that stopped: what colours it leaves
var<private> chance_key: u32;

fn start_passing(how: u32) {
    passing = select(ALL_STOP, how, (frame.flags & TRANSMITS) != 0u);
    passed_weight = vec3f(1.0);
    is_coloured = false;
}

// In [0, 1), a fixed number for each primitive and ray.
fn chance(primitive: u32, instance: u32) -> f32 {
    let state = hash_bits(hash_bits(chance_key ^ primitive) + instance);
    return f32(state >> 8u) * 0x1p-24f;
}

fn pass_at_random(tau: vec3f, mean: f32, passes: bool) -> bool {
    let coloured = any(tau != vec3f(tau.x));
    if passes {
        is_coloured = is_coloured || coloured;
        return false;
    }
    stopped_share = select(vec3f(1.0), (1.0 - tau) / max(1.0 - mean, 1e-6), coloured);
    return true;
}

fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool {
    stopped_share = vec3f(1.0);
    if passing == ALL_STOP {
        return true;
    }
    let record = rna_primitives[primitive];
    if !surface_has(rna_surface(record), LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.a].xyz;
    let ng = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let facing = dot(ng, ray.direction) < 0.0;
    let tau = transmittance(record, found.y, found.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
    let passes = mean > 0.0 && chance(primitive, instance) < mean;
    if passing == AT_RANDOM {
        return pass_at_random(tau, mean, passes);
    }
    if passes {
        passed_weight *= tau / mean;
    }
    return false;
}
`,"render/sampler.wgsl":`// Owen-scrambled Sobol' points, the very ones of rna_render.paths.sampling: a pure function of seed, pixel,
// sample and dimension.

fn hash_bits(value: u32) -> u32 {
    var x = (value ^ (value >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
fn owen(value: u32, seed: u32) -> u32 {
    var x = reverseBits(value) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

fn second_sobol(index: u32) -> u32 {
    var x = reverseBits(index);
    x ^= x << 16u;
    x ^= (x & 0x00ff00ffu) << 8u;
    x ^= (x & 0x0f0f0f0fu) << 4u;
    x ^= (x & 0x33333333u) << 2u;
    return x ^ ((x & 0x55555555u) << 1u);
}

// A point of the unit square for a dimension of the path at its present point.
fn square(pixel: u32, dimension: u32, number: u32) -> vec2f {
    let image_key = hash_bits(hash_bits(frame.seed) + dimension);
    let key = hash_bits(image_key ^ hash_bits(pixel + 1u));
    let index = owen(number, key);
    let first = owen(reverseBits(index), hash_bits(key + 1u));
    let second = owen(second_sobol(index), hash_bits(key + 2u));
    return vec2f(f32(first >> 8u), f32(second >> 8u)) * 0x1p-24f;
}

// Number of the path among all of its pixel that have come to this point.
fn path_of_pixel() -> u32 {
    return frame.sample * frame.branches + frame.branch;
}

fn at_point(pixel: u32, dimension: u32) -> vec2f {
    return square(pixel, (frame.depth - 1u) * DIMENSIONS + dimension, path_of_pixel());
}

// What a path's next ray passes at random through.
fn chance_of(pixel: u32) -> u32 {
    let path = hash_bits(hash_bits(frame.seed + 1u) ^ hash_bits(pixel + 1u));
    return hash_bits(hash_bits(path ^ path_of_pixel()) + frame.depth);
}
`,"render/scene_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const NONE: u32 = 0xffffffffu;
const SUM_BEAUTY: u32 = 0u;
const SUM_NORMAL: u32 = 1u;
const SUM_POSITION: u32 = 2u;
const SUM_LIGHT_SAMPLES: u32 = 3u;
const SUM_BEHIND: u32 = 4u;
const IS_LIGHT: u32 = 0x80000000u;
const MATERIAL_PART: u32 = 0xfffffffeu;
const CATCHER_PART: u32 = 0xfffffffdu;
const SUM_GROUPS: u32 = 5u;
const CAMERA_RAY: u32 = 1u;
const SHADOW_RAY: u32 = 4u;
const ALL_DIRECTIONS: u32 = 0xffffffffu;
const HEMISPHERE: u32 = 0xfffffffeu;
const CHOICES: u32 = 1u;
const DIRECTION: u32 = 2u;
const ROULETTE: u32 = 3u;
const LIGHT: u32 = 4u;
const DIMENSIONS: u32 = 7u;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u;

struct Frame { // 160 bytes
    camera: vec3f, // 0
    width: u32, // 12
    corner: vec3f, // 16; direction through the image's top left corner
    paths: u32, // 28
    step_x: vec3f, // 32; of a pixel
    sample: u32, // 44
    step_y: vec3f, // 48
    seed: u32, // 60
    depth: u32, // 64; points of the path so far
    light: u32, // 68; that is sampled; NONE: one that is chosen
    part: u32, // 72; number of the sample of this light at this point
    parts: u32, // 76; samples of this light at this point
    rays: u32, // 80; bit of the sort of rays
    clamp: f32, // 84
    light_count: u32, // 88
    sums: u32, // 92; vec4f of a path in \`sums\`: SUM_GROUPS, and two a group of lights
    flags: u32, // 96; of those below
    branch: u32, // 100; number of the ray that went on from the first point
    branches: u32, // 104; of those rays; 1 before them
    neural_part: u32, // 108
    list: u32, // 112; start in \`live\` of the list of paths that the step is for
    next_list: u32, // 116; likewise, of those that go on from there
    table_size: u32, // 120; of albedo
    objects: u32, // 124; this and the rest: starts of the sections of \`table\`
    surfaces: u32, // 128
    lights: u32, // 132
    albedo: u32, // 136
    domains: u32, // 140
    textures: u32, // 144
}

struct Path { // 96 bytes
    origin: vec3f, // 0
    pixel: u32, // 12
    direction: vec3f, // 16
    pdf: f32, // 28; of the direction; 0 of camera rays
    beta: vec3f, // 32
    state: u32, // 44
    normal: vec3f, // 48; of a segment
    t: f32, // 60
    instance: u32, // 64
    primitive: u32, // 68
    own: u32, // 72; instance that the ray passes through
    b1: f32, // 76
    leaving: vec3f, // 80; of a ray that leaves an asset: its start in object space
    b2: f32, // 92
}

struct Query { // 96 bytes
    x: vec3f, // 0
    h: f32, // 12
    axis: vec3f, // 16
    part: u32, // 28; whose decoder answers, or NONE, MATERIAL_PART, CATCHER_PART
    wo: vec3f, // 32
    light: u32, // 44
    wi: vec3f, // 48
    strand: u32, // 60; that a ray from here passes through
    weight: vec3f, // 64
    seen: f32, // 76; mean of what all that is in the way leaves of the light
    visible: vec3f, // 80; what the asset itself leaves of it
    reserved: u32, // 92
}

struct PathQueries { // 192 bytes
    at_point: Query, // 0; what the path's point scatters or emits
    at_light: Query, // 96; what an asset emits at its point that was sampled as a light
}
`,"render/surfaces.wgsl":`// Surfaces of the scene, by the number that primitives have; scene_surfaces.py fills them.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

fn surface_has(surface: u32, flag: u32) -> bool {
    return (surface_flags(surface) & flag) != 0u;
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = surface_second_uvs(surface) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: RnaPrimitive, uv_set: u32) -> mat3x2f {
    let surface = rna_surface(record);
    return mat3x2f(
        corner_uv(surface, record.a, uv_set),
        corner_uv(surface, record.b, uv_set),
        corner_uv(surface, record.c, uv_set),
    );
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
`,"render/table_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const OF_MATERIAL: u32 = 0u;
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;
const EMITS: u32 = 1u;
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u;
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;
const BASE: u32 = 0u;
const METAL: u32 = 1u;
const COAT: u32 = 2u;
const GLOW: u32 = 3u;
const CLEAR: u32 = 4u;
const CLEAR_ROUGH: u32 = 5u;
const THROUGH: u32 = 6u;
const RELIEF: u32 = 7u;
const LIGHT_SEEN: u32 = 1u;
const LIGHT_DELTA: u32 = 2u;
const LIGHT_INFINITE: u32 = 4u;
const DIRECTIONAL: u32 = 0u;
const SUN: u32 = 1u;
const POINT: u32 = 2u;
const RECTANGLE: u32 = 3u;
const DISK: u32 = 4u;
const SPHERE: u32 = 5u;
const UNIFORM: u32 = 6u;
const IMAGE: u32 = 7u;
const TRIANGLES: u32 = 8u;

fn object_number(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].x;
}
fn object_catches(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].y);
}
fn object_step(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].z;
}
fn object_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].w);
}

fn surface_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].x);
}
fn surface_part(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].y);
}
fn surface_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].z);
}
fn surface_normal_map(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].w);
}
fn surface_base_color(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 1u].xyz;
}
fn surface_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 1u].w;
}
fn surface_metallic(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].x;
}
fn surface_coat_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].y;
}
fn surface_coat_weight(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].z;
}
fn surface_transmission(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].w;
}
fn surface_emission(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 3u].xyz;
}
fn surface_normal_scale(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 3u].w;
}
fn surface_clear_coat(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].x;
}
fn surface_clear_coat_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].y;
}
fn surface_second_uvs(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].z);
}
fn surface_tangents(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].w);
}
fn surface_textures(k: u32, i: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 5u + i / 4u][i % 4u]);
}
fn surface_through(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 7u].x);
}
fn surface_cutoff(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 7u].y;
}
fn surface_ior(k: u32) -> vec2f {
    return table[frame.surfaces + 9u * k + 7u].zw;
}
fn surface_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 8u].x;
}

fn texture_place(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].x);
}
fn texture_size(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].y);
}
fn texture_form(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].z);
}
fn texture_row_u(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 1u].xyz;
}
fn texture_row_v(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 2u].xyz;
}

fn light_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].x);
}
fn light_group(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].y);
}
fn light_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].z);
}
fn light_instance(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].w);
}
fn light_numbers(k: u32, i: u32) -> f32 {
    return table[frame.lights + 8u * k + 1u + i / 4u][i % 4u];
}
fn light_probability(k: u32) -> vec3f {
    return table[frame.lights + 8u * k + 6u].xyz;
}
fn light_places(k: u32) -> vec4<u32> {
    return bitcast<vec4<u32>>(table[frame.lights + 8u * k + 7u].xyzw);
}

fn light_colour(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 0u), light_numbers(k, 1u), light_numbers(k, 2u));
}
fn directional_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_one_minus_cosine(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn point_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn point_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 6u), light_numbers(k, 7u), light_numbers(k, 8u));
}
fn point_cos_inner(k: u32) -> f32 {
    return light_numbers(k, 9u);
}
fn point_cos_outer(k: u32) -> f32 {
    return light_numbers(k, 10u);
}
fn rectangle_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn rectangle_half(k: u32) -> vec2f {
    return vec2f(light_numbers(k, 15u), light_numbers(k, 16u));
}
fn disk_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn disk_radius(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn sphere_centre(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sphere_radius(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_turn_cosine(k: u32) -> f32 {
    return light_numbers(k, 3u);
}
fn image_turn_sine(k: u32) -> f32 {
    return light_numbers(k, 4u);
}
fn image_total(k: u32) -> f32 {
    return light_numbers(k, 5u);
}
fn image_mean(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_rows(k: u32) -> f32 {
    return light_numbers(k, 7u);
}
fn image_columns(k: u32) -> f32 {
    return light_numbers(k, 8u);
}
fn triangles_rotation(k: u32) -> mat3x3f {
    return mat3x3f(light_numbers(k, 3u), light_numbers(k, 6u), light_numbers(k, 9u), light_numbers(k, 4u), light_numbers(k, 7u), light_numbers(k, 10u), light_numbers(k, 5u), light_numbers(k, 8u), light_numbers(k, 11u));
}
fn triangles_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 12u), light_numbers(k, 13u), light_numbers(k, 14u));
}
fn triangles_scale(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_texels(k: u32) -> u32 {
    return light_places(k).x;
}
fn image_heights(k: u32) -> u32 {
    return light_places(k).y;
}
fn image_row_sums(k: u32) -> u32 {
    return light_places(k).z;
}
fn image_column_sums(k: u32) -> u32 {
    return light_places(k).w;
}
fn triangles_sums(k: u32) -> u32 {
    return light_places(k).x;
}
fn triangles_primitives(k: u32) -> u32 {
    return light_places(k).y;
}
fn triangles_densities(k: u32) -> u32 {
    return light_places(k).z;
}
fn triangles_count(k: u32) -> u32 {
    return light_places(k).w;
}
`,"render/textures.wgsl":`// Textures on triangles: rna_render/materials/textures.py. A texel is a u32 of three bytes.

const REPEAT: u32 = 0u;
const MIRROR: u32 = 2u;

struct Image {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32,
}

fn image_of(texture: u32) -> Image {
    let size = texture_size(texture);
    return Image(
        texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture),
    );
}

fn texel(at: Image, column: u32, row: u32) -> vec3f {
    let word = images[at.place + row * at.size.x + column];
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & 16u) == 0u {
        return c;
    }
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct Around {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn texels_around(x: f32, size: u32, wrap: u32) -> Around {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == REPEAT {
        inside = x - floor(x);
    } else if wrap == MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == REPEAT {
        let wrapped = select(first, last, first < 0);
        return Around(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return Around(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, mixed after decoding, at the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    let at = image_of(texture);
    let u = dot(texture_row_u(texture), vec3f(uv, 1.0));
    let v = dot(texture_row_v(texture), vec3f(uv, 1.0));
    let x = texels_around(u, at.size.x, at.form & 3u);
    let y = texels_around(v, at.size.y, (at.form >> 2u) & 3u);
    let upper = mix(texel(at, x.first, y.first), texel(at, x.second, y.first), x.part);
    let lower = mix(texel(at, x.first, y.second), texel(at, x.second, y.second), x.part);
    return mix(upper, lower, y.part);
}

// On a triangle at barycentrics.
fn texture_on(texture: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    return surface_emission(rna_surface(record)) * factor_on(GLOW, record, b1, b2);
}
`,"render/tracing.wgsl":`// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray; \`key\` decides what it passes.
fn closest_through(ray: RnaRay, own: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let found = rna_trace(line, own, frame.rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, found);
        let is_triangle = (hit.instance & IS_LIGHT) == 0u
            && !rna_is_segment(rna_primitives[hit.primitive]);
        share = select(share, stopped_share, is_triangle);
        if !is_coloured {
            break;
        }
        passing = WEIGH;
        line.far = hit.t;
    }
    return Through(hit, share * passed_weight);
}

// What a shadow ray keeps of its light.
fn kept_on(ray: RnaRay, own: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, own, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn own_kept(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
    var hit = rna_miss(ray.far);
    let root = rna_instances[instance].root;
    start_passing(WEAKEN);
    let stopped = rna_trace_body(root, ray, strand, true, &hit);
    return select(passed_weight, vec3f(0.0), stopped);
}
`,"render/transmittance.wgsl":`// What triangles let through, of materials and of assets: spec/RNA.md, 4.4 Transmittance, and
// rna_trace/transmittance.py.

// Unpolarised, of an interface of relative index eta.
fn dielectric_reflectance(eta: f32, cosine: f32) -> f32 {
    let squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if squared <= 0.0 {
        return 1.0;
    }
    let root = sqrt(squared);
    let s = (cosine - eta * root) / (cosine + eta * root);
    let p = (eta * cosine - root) / (eta * cosine + root);
    return 0.5 * (s * s + p * p);
}

// The part that a smooth interface does not reflect of a ray along d, in object space.
fn passed_interface(
    record: RnaPrimitive, b: vec3f, d: vec3f, facing: bool,
) -> f32 {
    let surface = rna_surface(record);
    let ior = surface_ior(surface);
    let eta = select(ior.y, ior.x, facing);
    let schlick = surface_has(surface, HAS_SCHLICK);
    if eta == 0.0 && !schlick {
        return 1.0;
    }
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz) * b;
    let cosine = min(abs(dot(n, d)) / max(sqrt(dot(n, n) * dot(d, d)), 1e-30), 1.0);
    if eta != 0.0 {
        return 1.0 - dielectric_reflectance(eta, cosine);
    }
    let f0 = surface_f0(surface);
    let away = 1.0 - cosine;
    return (1.0 - f0) * (1.0 - away * away * away * away * away);
}

// Of a triangle, for a ray along d in object space. facing: it meets the normal's side.
fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    let surface = rna_surface(record);
    if !surface_has(surface, LETS_THROUGH) {
        return vec3f(0.0);
    }
    var tau = texture_on(surface_through(surface), record, b1, b2);
    if surface_has(surface, HAS_CUTOFF) {
        tau = select(vec3f(0.0), vec3f(1.0), tau > vec3f(surface_cutoff(surface)));
    }
    let passed = passed_interface(record, weights_of(b1, b2), d, facing);
    return min(tau * passed, vec3f(1.0));
}
`,"render/triangle_lights.wgsl":`// Triangles that shine, of an object or an asset: rna_render/lights/mesh.py. In \`images\` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let area = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let sums_at = triangles_sums(light);
    let count = triangles_count(light);
    if count == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(sums_at + count);
    let chosen = interval(sums_at, count, value);
    let root = sqrt(place_within(sums_at, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[triangles_primitives(light) + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let way = p - x + b.x * (rna_points[record.b].xyz - p) + b.y * (rna_points[record.c].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[instance].scale;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_colour(light);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
`,"render/vertex.wgsl":`// The point that a path has come to, from its hit.

struct Vertex {
    x: vec3f, // object space, as all that is not said otherwise
    kind: u32,
    n: vec3f, // interpolated normal, or that of a segment
    surface: u32,
    ng: vec3f,
    part: u32,
    lift: vec3f,
    h: f32,
    axis: vec3f, // of a decoder's queries: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: RnaPrimitive, // of its primitive
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: RnaPrimitive, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
    );
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz);
    v.x = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
    let mixed = n * b;
    v.n = select(vec3f(0.0), mixed / max(length(mixed), 1e-30), dot(mixed, mixed) > 0.0);
    let area = cross(p[1] - p[0], p[2] - p[0]);
    let largest = max(abs(area.x), max(abs(area.y), abs(area.z)));
    if largest > 0.0 {
        v.ng = normalize(area / largest);
    }
    v.lift = rna_lift(v.x, b, p, n);
    v.shading = v.n;
    v.b1 = b1;
    v.b2 = b2;
    let map = surface_normal_map(rna_surface(record));
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

fn segment_vertex(path: Path, record: RnaPrimitive, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = path.normal;
    v.ng = path.normal;
    v.x = path.t * rna_object_direction(path.direction, path.instance)
        / rna_instances[path.instance].scale
        + rna_object_point(path.origin, path.instance);
    v.x = on_cone(cone, v.x, v.n);
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// The point of the surface of normal n near x: that of the sphere which touches it there. The error
// of x is that of its ray's length.
fn on_cone(cone: RnaCone, x: vec3f, n: vec3f) -> vec3f {
    let way = cone.b - cone.a;
    let radius = dot(x - cone.a, n);
    let along = dot(x - cone.a - clamp(radius, 0.0, max(cone.ra, cone.rb)) * n, way);
    let u = clamp(along / dot(way, way), 0.0, 1.0);
    return mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(path, record, wo);
    }
    v.record = record;
    v.surface = rna_surface(record);
    v.kind = surface_kind(v.surface);
    v.part = surface_part(v.surface);
    if v.kind == OF_MATERIAL {
        v.shading = bumped_normal(record, v.b1, v.b2, v.n, v.ng, wo);
    }
    v.wo = wo;
    v.instance = path.instance;
    v.x_world = rna_world_point(v.x, path.instance);
    v.n_world = rna_world_direction(v.shading, path.instance);
    v.ng_world = rna_world_direction(v.ng, path.instance);
    return v;
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    let step = object_step(v.instance);
    return v.x_world + select(step, -step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Origin of the visibility ray along wi against the asset itself; object space.
fn leaving_point(v: Vertex, wi: vec3f) -> vec3f {
    if v.kind == OF_FIBERS {
        return v.x;
    }
    let extent = rna_instances[v.instance].extent;
    return rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, extent);
}

fn instance_scale(instance: u32) -> f32 {
    return rna_instances[instance].scale;
}
`,"row_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

struct RnaRow { // 64 bytes
    position: vec3<u32>, // 0; object space
    h: u32, // 12
    axis: vec3<u32>, // 16; normal or tangent
    reserved: u32, // 28
    wo: vec3<u32>, // 32
    reserved_2: u32, // 44
    wi: vec3<u32>, // 48
    reserved_3: u32, // 60
}
`,"segment.wgsl":`// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn rna_cone(point: u32) -> RnaCone {
    let a = rna_points[point];
    let b = rna_points[point + 1u];
    return RnaCone(a.xyz, a.w, b.xyz, b.w);
}

// Along d from p to where it enters the sphere; RNA_FAR where it does not.
fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    let v = p - centre;
    let along = dot(v, d);
    let rest = v - along * d;
    let h = radius * radius - dot(rest, rest);
    if h <= 0.0 {
        return RNA_FAR;
    }
    return -along - sqrt(h);
}

// How far p is outside of the cone; negative inside.
fn rna_cone_distance(cone: RnaCone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let size = length(axis);
    let dr = cone.ra - cone.rb;
    let v = p - cone.a;
    let y = dot(v, axis) / size;
    let x = length(v - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size <= abs(dr) {
        return select(to_b, to_a, dr > 0.0);
    }
    let slope = dr / size;
    let lean = sqrt(1.0 - slope * slope);
    let along = y * lean - x * slope;
    if along <= 0.0 {
        return to_a;
    }
    if along >= size * lean {
        return to_b;
    }
    return x * lean + y * slope - cone.ra;
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. \`from\` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), vec3f(0.0));
    entry.normal = p + entry.t * d - select(cone.b, cone.a, ta < tb);
    let axis = cone.b - cone.a;
    let v = p - cone.a;
    let dr = cone.ra - cone.rb;
    let squared = dot(axis, axis);
    let d2 = squared - dr * dr;
    let m1 = dot(axis, v);
    let m2 = dot(axis, d);
    let k2 = d2 - m2 * m2;
    let k1 = d2 * dot(d, v) - m1 * m2 + m2 * dr * cone.ra;
    let k0 = d2 * dot(v, v) - m1 * m1 + 2.0 * m1 * dr * cone.ra - squared * cone.ra * cone.ra;
    let h = k1 * k1 - k0 * k2;
    if d2 <= 0.0 || h < 0.0 || k2 == 0.0 {
        return entry;
    }
    for (var sign = -1.0; sign <= 1.0; sign += 2.0) {
        let side = (sign * sqrt(h) - k1) / k2;
        let y = m1 - cone.ra * dr + side * m2;
        let normal = d2 * (v + side * d) - axis * y;
        if y > 0.0 && y < d2 && side < entry.t && dot(normal, d) < 0.0 {
            entry = RnaEntry(side, normal);
        }
    }
    return entry;
}

// Whether p, on a segment, is inside the one before or after it: there is no surface there.
fn rna_in_neighbour(segment: RnaPrimitive, p: vec3f) -> bool {
    if (segment.b & RNA_HAS_BEFORE) != 0u {
        let before = rna_cone(segment.a - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.b & RNA_HAS_AFTER) != 0u {
        let after = rna_cone(segment.a + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
    let cone = rna_cone(segment.a);
    let shift = dot(0.5 * (cone.a + cone.b) - ray.origin, ray.direction);
    let p = ray.origin + shift * ray.direction;
    let entry = rna_enter_cone(cone, p, ray.direction);
    let t = entry.t + shift;
    if entry.t >= RNA_FAR || !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    if rna_in_neighbour(segment, p + entry.t * ray.direction) {
        return miss;
    }
    return RnaEntry(t, normalize(entry.normal));
}
`,"surface.wgsl":`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi.
fn rna_surface(x: vec3f, n: vec3f, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`,"surface_blocks.wgsl":`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(0.5 * dot(gap, gap) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    rna_put(slot, vec4f(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    if slot == RNA_NONE {
        return;
    }
    var q = n + 0.1 * features;
    let size = length(q);
    if size < 1e-6 {
        q = n;
    } else {
        q = q / size;
    }
    let m = rna_halfway(wo, wi, q);
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    let m = rna_halfway(wo, wi, n);
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, wo, wi);
}
`,"triangle.wgsl":`// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
// Ray/Triangle Intersection (JCGT 2(1), 2013).

// Coordinates with the ray's largest one last.
fn rna_turned(v: vec3f, axis: u32) -> vec3f {
    if axis == 0u {
        return v.yzx;
    }
    if axis == 1u {
        return v.zxy;
    }
    return v;
}

fn rna_largest_axis(d: vec3f) -> u32 {
    let size = abs(d);
    if size.x > size.y && size.x > size.z {
        return 0u;
    }
    return select(2u, 1u, size.y > size.z);
}

// (t, b1, b2), t of RNA_FAR for a miss.
fn rna_meet_triangle(ray: RnaRay, p0: vec3f, p1: vec3f, p2: vec3f) -> vec3f {
    let miss = vec3f(RNA_FAR, 0.0, 0.0);
    let axis = rna_largest_axis(ray.direction);
    let d = rna_turned(ray.direction, axis);
    let shear = vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z);
    let a = rna_turned(p0 - ray.origin, axis);
    let b = rna_turned(p1 - ray.origin, axis);
    let c = rna_turned(p2 - ray.origin, axis);
    let a2 = a.xy - shear.xy * a.z;
    let b2 = b.xy - shear.xy * b.z;
    let c2 = c.xy - shear.xy * c.z;
    let u = c2.x * b2.y - c2.y * b2.x;
    let v = a2.x * c2.y - a2.y * c2.x;
    let w = b2.x * a2.y - b2.y * a2.x;
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return miss;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return miss;
    }
    let t = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
    if !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    return vec3f(t, v / sum, w / sum);
}
`,"visibility.wgsl":`// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

// From x, at barycentric coordinates b of a triangle, onto the smooth surface it stands for.
fn rna_lift(x: vec3f, b: vec3f, p: mat3x3f, n: mat3x3f) -> vec3f {
    return b.x * max(0.0, dot(p[0] - x, n[0])) * n[0]
        + b.y * max(0.0, dot(p[1] - x, n[1])) * n[1]
        + b.z * max(0.0, dot(p[2] - x, n[2])) * n[2];
}

// n: interpolated, ng: of the triangle; extent: largest absolute coordinate of the asset.
fn rna_leaving_origin(
    x: vec3f, n: vec3f, ng: vec3f, lift: vec3f, wi: vec3f, extent: f32,
) -> vec3f {
    let step = extent * 0x1p-18f;
    let above = dot(ng, wi);
    if dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && above < 0.1 {
        return x + (1.0 - max(0.0, above) / 0.1) * lift + step * ng;
    }
    return x + select(step, -step, above < 0.0) * ng;
}
`,"weights_storage.wgsl":`// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`,"weights_uniform.wgsl":`// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`};var mt=`// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light: LIGHT_SUN and so on
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // of the queries, + 1
    form: u32,     // of the answers: FORM_TRANSPORT, two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    pixels: u32,   // of the whole picture
    shares: f32,   // rays a pixel of the first look's edges
}

const FORM_TRANSPORT = 0u;
const FORM_EMISSION = 1u;
const FORM_ENVIRONMENT = 2u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
}

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var No=`// What decoders of lobes are told of the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn tell_visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= count[0] {
        return;
    }
    let pixel = band[count[at + 1u]];
    let record = primitives[pixel.wo.w];
    let is_segment = (record.tag & RNA_IS_SEGMENT) != 0u;
    let second = select(record.b, record.a + 1u, is_segment);
    let third = select(record.c, record.a, is_segment);
    for (var k = 0u; k < 4u; k++) {
        let first = (1.0 - pixel.b1 - pixel.b2) * harmonic(record.a, k);
        columns[4u * at + k] = first + pixel.b1 * harmonic(second, k) + pixel.b2 * harmonic(third, k);
    }
}
`;var Io=`// A ray from the camera through each pixel of the band, to the query of its first hit.

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    return found;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, wo: vec3f) -> Pixel {
    var pixel: Pixel;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        var path: Path;
        path.origin = frame.camera;
        path.direction = -wo;
        path.t = hit.t;
        path.normal = hit.normal;
        v = segment_vertex(path, record, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
    return pixel;
}

@compute @workgroup_size(64)
fn trace_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let place = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter) + view.shift;
    let d = normalize(frame.corner + at.x * frame.step_x + at.y * frame.step_y);
    let ray = RnaRay(frame.camera, 0.0, d, RNA_FAR);
    let found = closest_through(ray, RNA_NOTHING, chance_of(number));
    var pixel = pixel_of(found.hit, -d);
    pixel.through = found.weight;
    band[k] = pixel;
}

// The normals of hits whose primitives and barycentric coordinates are in the band.
@compute @workgroup_size(64)
fn find_normals(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let hit = RnaHit(0.0, 0u, band[k].wo.w, band[k].b1, band[k].b2, vec3f(0.0));
        band[k].axis = pixel_of(hit, bitcast<vec3f>(band[k].wo.xyz)).axis;
    }
}
`;var To=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, fisher_cosine(u.y / share, MIRROR_KAPPA), u.x));
    }
    let rest = (u.y - share) / (1.0 - share);
    let all_sides = rest < FROM_ALL_SIDES;
    let v = select((rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES), rest / FROM_ALL_SIDES, all_sides);
    let ball = along_axis(vec3f(0.0, 0.0, 1.0), 1.0 - 2.0 * v, u.x);
    return normalize(ball + select(at.n * 1.0001, vec3f(0.0), all_sides));
}

fn density_about(at: Surroundings, wi: vec3f) -> f32 {
    if all(at.n == vec3f(0.0)) {
        return SPHERE_PDF;
    }
    let rest = mix(max(0.0, dot(at.n, wi)) / PI, SPHERE_PDF, FROM_ALL_SIDES);
    return mix(rest, fisher_pdf(dot(at.mirror, wi), MIRROR_KAPPA), mirrored_share(at));
}

fn surroundings_of(pixel: Pixel) -> Surroundings {
    if pixel.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if rna_is_segment(rna_primitives[pixel.wo.w]) {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// The direction that lobes are asked with. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(number: u32, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let u = at_point(number, DIRECTION);
        let wi = normalize(along_axis(vec3f(0.0, 1.0, 0.0), 1.0 - 2.0 * u.y, u.x) + vec3f(0.0, 1.0001, 0.0));
        return Arrival(wi, view.colour / max(wi.y, 1e-3));
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    let m = select(reflect(-wo, axis), reflect(wo, axis), rna_is_segment(rna_primitives[pixel.wo.w]));
    return Arrival(m, vec3f(1.0));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == LIGHT_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == LIGHT_GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let at = surroundings_of(pixel);
    if view.kind == LIGHT_MIRROR {
        return mirrored(number, pixel);
    }
    if view.kind == LIGHT_ENVIRONMENT {
        let bright = sample_image(0u, at_point(number, LIGHT));
        return Arrival(bright.wi, bright.radiance / (bright.pdf + density_about(at, bright.wi)));
    }
    let wi = direction_about(at, at_point(number, DIRECTION));
    let sky = look_up_image(0u, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + density_about(at, wi)));
}

// How much of the light along wi the asset itself lets through to a point of it.
fn visibility_of(pixel: Pixel, wi: vec3f) -> vec3f {
    let record = rna_primitives[pixel.wo.w];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = rna_strand(record);
    }
    return own_kept(0u, RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR), v.strand);
}

// The ground, seen along d, shows the shadow and fades with the distance: what it sends on of light along wi; and how
// much it covers.
fn ground_seen(d: vec3f, wi: vec3f) -> vec4f {
    if view.ground_size == 0.0 || d.y * (frame.camera.y - view.ground) >= 0.0 {
        return vec4f(0.0);
    }
    let x = frame.camera + d * ((view.ground - frame.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    if all(weight <= vec3f(0.0)) {
        return vec4f(0.0, 0.0, 0.0, fade);
    }
    let step = 0x1p-18f * rna_instances[0].extent;
    let way = RnaRay(x + vec3f(0.0, step, 0.0), 0.0, wi, RNA_FAR);
    return vec4f(weight * own_kept(0u, way, RNA_NOTHING), fade);
}

@compute @workgroup_size(64)
fn light_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    var pixel = band[k];
    let arrival = arrival_at(view.first + k, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    pixel.radiance = pixel.through * arrival.radiance;
    if pixel.axis.w != 0u {
        pixel.visibility = visibility_of(pixel, arrival.wi);
    } else {
        let ground = ground_seen(-bitcast<vec3f>(pixel.wo.xyz), arrival.wi);
        pixel.radiance *= ground.xyz;
        pixel.coverage = ground.w;
    }
    band[k] = pixel;
}
`;var Oo=`// The first look without jagged edges: more rays a pixel, each with the light of the pixels nearby that saw what it sees.

@group(2) @binding(0) var<storage, read_write> seen: array<vec4<u32>>; // from pixels' middles: distance, axis, part + 1
@group(2) @binding(1) var<storage, read_write> look: array<vec4f>;

const UNLIKE = 8.0; // weight of differences: of axes, and of distances to a plane in pixels
const APART = 3.0;  // and of the distance in the picture, pixels squared
const APART_ON_GROUND = 0.5; // whose light is noisy

fn raw_direction(place: vec2f) -> vec3f {
    return frame.corner + place.x * frame.step_x + place.y * frame.step_y;
}

// What the band's pixels see from their middles.
@compute @workgroup_size(64)
fn remember(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let pixel = band[k];
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let away = length(bitcast<vec3f>(pixel.position.xyz) - frame.camera);
    let packed = vec2<u32>(pack2x16snorm(axis.xy), pack2x16snorm(vec2f(axis.z, 0.0)));
    seen[view.first + k] = vec4<u32>(bitcast<u32>(away), packed, pixel.axis.w);
}

// How unlike what the pixel at \`place\` saw from its middle is to a hit of the same part.
fn difference(hit: Pixel, other: vec4<u32>, place: vec2f) -> f32 {
    if hit.axis.w == 0u {
        return 0.0;
    }
    let n = bitcast<vec3f>(hit.axis.xyz);
    let raw = raw_direction(place);
    let away = bitcast<f32>(other.x);
    let x = frame.camera + away * normalize(raw);
    let size = away * length(frame.step_x) / length(raw); // of a pixel there
    let off = abs(dot(n, x - bitcast<vec3f>(hit.position.xyz))) / max(size, 1e-30);
    return 1.0 - dot(n, vec3f(unpack2x16snorm(other.y), unpack2x16snorm(other.z).x)) + off;
}

// The light of the neighbours that are like the band's hit, whose ray went beside the middle by the view's shift.
fn light_beside(number: u32, hit: Pixel) -> vec4f {
    let middle = vec2<i32>(vec2<u32>(number % frame.width, number / frame.width));
    let narrow = select(APART, APART_ON_GROUND, hit.axis.w == 0u);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var j = 0; j < 9; j++) {
        let step = vec2<i32>(j % 3 - 1, j / 3 - 1);
        let at = middle + step;
        let there = u32(at.y) * frame.width + u32(at.x);
        if at.x < 0 || at.y < 0 || at.x >= i32(frame.width) || there >= view.pixels || seen[there].w != hit.axis.w {
            continue;
        }
        let apart = vec2f(step) - view.shift;
        let unlike = min(difference(hit, seen[there], vec2f(at) + 0.5), 4.0);
        let weight = exp(-UNLIKE * unlike - narrow * dot(apart, apart));
        sum += weight * sums[there];
        total += weight;
    }
    if total == 0.0 {
        return select(sums[number], vec4f(0.0), hit.axis.w == 0u); // nobody saw such a thing
    }
    return sum / total;
}

// One of \`view.shares\` rays a pixel.
@compute @workgroup_size(64)
fn smooth_edges(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let before = select(look[number], vec4f(0.0), view.is_first == 1u);
    look[number] = before + light_beside(number, band[k]) / view.shares;
}
`;var ms=`// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; then its visibility
@group(1) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(1) @binding(2) var<storage, read> count: array<u32>; // [0]
@group(1) @binding(3) var<storage, read> columns: array<vec4f>; // 4 a row
@group(2) @binding(0) var<uniform> light: LobeLight;
@group(2) @binding(1) var prefiltered: texture_2d_array<f32>;
@group(2) @binding(2) var smooth_sampler: sampler;

fn mean_under(lobe: RnaLobe) -> vec3f {
    let d = lobe.axis;
    let x = light.turn.x * d.x - light.turn.y * d.z;
    let z = light.turn.y * d.x + light.turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    let azimuth = select(0.0, atan2(x, -z), sine > 0.0);
    let size = vec2f(textureDimensions(prefiltered));
    let polar = atan2(sine, d.y) / 3.14159265; // the first row is one pole, the last one the other
    let place = vec2f(0.5 + azimuth / 6.28318531, (polar * (size.y - 1.0) + 0.5) / size.y);
    let level = clamp(log2(lobe.kappa / light.least_kappa) * light.an_octave, 0.0, light.levels - 1.0);
    let wide = u32(level);
    let a = textureSampleLevel(prefiltered, smooth_sampler, place, wide, 0.0).xyz;
    let b = textureSampleLevel(prefiltered, smooth_sampler, place, min(wide + 1u, u32(light.levels) - 1u), 0.0).xyz;
    return mix(a, b, level - f32(wide));
}

@compute @workgroup_size(64)
fn light_by_lobes(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= count[0] {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let place = rna_run_lobes(bitcast<vec3f>(at.position), axis, bitcast<f32>(at.h), wo, m, visibility);
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.reserved_3));
        sum += lobe.amplitude * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
`;var gs=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

@group(2) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(2) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

// What a light brings to the ground, and the coverage. \`sums\` are of the whole picture.
@compute @workgroup_size(64)
fn begin(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let is_query = band[k].axis.w != 0u;
    let covered = select(band[k].coverage, 1.0, is_query) * f32(view.counts_coverage);
    let before = select(sums[view.first + k], vec4f(0.0), view.is_first == 1u);
    sums[view.first + k] = before + vec4f(select(band[k].radiance, vec3f(0.0), is_query), covered);
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    rows[at] = RnaRow(pixel.position.xyz, pixel.position.w, pixel.axis.xyz, 0u, pixel.wo.xyz, 0u, wi.xyz, bitcast<u32>(free));
}

@compute @workgroup_size(64)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let k = atomicLoad(&count[at + 1u]);
    let pixel = band[k];
    var radiance = pixel.through * answers[at].xyz;
    if view.form == FORM_TRANSPORT {
        radiance = pixel.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, pixel.visibility);
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var _s=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec3f, // linear light of the screen
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    first_look: f32, // share of the first look in what is shown, 0 to 1
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

// The mean of the samples and the first look.
fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    let k = place.y * u32(shown.picture.x) + place.x;
    if shown.first_look >= 1.0 {
        return first_look[k];
    }
    let mean = sums[k] / shown.rounds;
    if shown.first_look <= 0.0 {
        return mean;
    }
    return mix(mean, first_look[k], shown.first_look);
}

// As rna_render/image/view_transform.py, which names the source.
fn filmic(radiance: vec3f) -> vec3f {
    let c = 1.461926 * min(radiance, vec3f(1e9));
    let x = vec3f(dot(c, vec3f(0.59719, 0.35458, 0.04823)), dot(c, vec3f(0.07600, 0.90834, 0.01566)),
                  dot(c, vec3f(0.02840, 0.13383, 0.83777)));
    // Both parts divided by x, so that none overflows.
    let inverse = 1.0 / max(x, vec3f(1e-9));
    let y = (x + 0.0245786 - 0.000090537 * inverse) / (0.983729 * x + 0.4329510 + 0.238081 * inverse);
    return vec3f(dot(y, vec3f(1.60475, -0.53108, -0.07367)), dot(y, vec3f(-0.10208, 1.10813, -0.00605)),
                 dot(y, vec3f(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, of a mean.
fn displayed(mean: vec4f) -> vec3f {
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let linear = clamp(light, vec3f(0.0), vec3f(1.0)) + max(0.0, 1.0 - mean.w) * shown.backdrop;
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return clamp(encoded, vec3f(0.0), vec3f(1.0));
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y);
    let here = displayed(mean);
    if (shown.spread == 0.0) {
        return vec4f(here, 1.0);
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = vec4f(here, 1.0);
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y);
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            sum += vec4f(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
        }
    }
    return vec4f(sum.xyz / sum.w, 1.0);
}
`;var Mo=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, vec3f(0.0));
}
`;var Lo=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let r of[mt,ms,gs,_s])qs(r);var Po=r=>r in ot?[r]:dt[r].flatMap(Po),Gt=(r,e=ot)=>[...new Set(r.flatMap(Po))].map(t=>e[t]).join(`
`);function rr(r,...e){return Object.entries(r).map(([n,s])=>`const ${n}: u32 = ${s}u;
`).join("")+Gt(e)}function sr({hasSegments:r,hasTextures:e}){let t={...ot};return r||(t["segment.wgsl"]=Mo),e||Object.assign(t,{"normal_maps.wgsl":Lo,"render/transmittance.wgsl":""}),{hit:Gt(dt.hit,t)+mt+Io,light:[Gt(dt.light,t),mt,js,To].join(`
`)}}var gt={columns:Gt(dt.columns)+mt+No,lobes:`${ot["environment_lobes.wgsl"]}
${ot["row_records.wgsl"]}
${ms}`,look:Gt(dt.queue)+mt+Oo,queue:Gt(dt.queue)+mt+gs,show:_s};var ir=class{constructor(e){this.device=e,this.made=new Map}get(e,t,n){let s=`${t}
${e}`;return this.made.has(s)||this.made.set(s,this._make(e,t,n)),this.made.get(s)}async _make(e,t,n){let s=await Qn(this.device,e),i=n?this.device.createPipelineLayout({bindGroupLayouts:n}):"auto";return this.device.createComputePipelineAsync({layout:i,compute:{module:s,entryPoint:t}})}},qt=class{static make(e,t,n,s,i,o){let l={constants:{RNA_COLOURS:s.outputs===6?2:1},parts:[n.kind,"evaluate"],kernel:"",entryPoint:"rna_evaluate"};return this.of(e,t,nr(n,s,i),o,l)}static async of(e,t,{weights:n,record:s,groups:i},o,{constants:c,parts:l,kernel:f,entryPoint:h}){let d=new this,{UNIFORM_WEIGHTS:g}=ce,w=n.length/4<=g,k=w?"weights_uniform.wgsl":"weights_storage.wgsl";d.pipeline=await t.get(rr({RNA_GROUPS:i,...c},k,...l)+f,h);let{UNIFORM:S,STORAGE:L}=GPUBufferUsage,Z=w?new Float32Array(4*g):n;return w&&Z.set(n),d.buffers=[te(e,s,S,"a decoder"),te(e,Z,w?S:L,"a decoder")],d.part=hn(e,d.pipeline,0,[...d.buffers,...o]),d.device=e,d}run(e,{rows:t,answers:n,count:s},i){this.dispatch(e,[t,n,s],i)}dispatch(e,t,n,s=[]){this.bound??=hn(this.device,this.pipeline,1,t),ue(e,this.pipeline,[this.part,this.bound,...s],n)}delete(){for(let e of this.buffers)e.destroy()}};function Fo(r,[e,t]){let n=e+1,s=r.reduce((c,l)=>c+l,0)/r.length||1,i=Uu(r,e,t,s),o=new Uint16Array(4*t*n*19);for(let c=0;c<19;c++){let l=.25*2**(c/2);for(let f=0;f<n;f++){let h=Du(i,Math.PI*f/e,e,t/2,l);Hu(o,4*t*(c*n+f),h,t)}}return{texels:o,width:t,height:n,levels:19,unit:s}}var Co=r=>Float64Array.from({length:r},(e,t)=>Math.cos(2*Math.PI*t/r)),zo=(r,e)=>2*Math.PI*(Math.cos(Math.PI*r/e)-Math.cos(Math.PI*(r+1)/e));function Uu(r,e,t,n){let s=t/2,i=new Float64Array(6*e*s),o=Co(t);for(let c=0;c<e;c++){let l=zo(c,e)/t;for(let f=0;f<s;f++)for(let h=0;h<t;h++){let d=f*h,g=6*(c*s+f),w=3*(c*t+h),k=l/n*o[d%t],S=l/n*o[(d+.75*t)%t];for(let L=0;L<3;L++)i[g+L]+=r[w+L]*k,i[g+3+L]+=r[w+L]*S}}return i}function Du(r,e,t,n,s){let i=new Float64Array(6*n),o=new Float64Array(n),c=0;for(let l=0;l<t;l++){let f=Math.PI*(l+.5)/t,h=Math.exp(s*(Math.cos(e-f)-1));if(!(h<1e-6)){$u(s*Math.sin(e)*Math.sin(f),o),c+=h*o[0]*zo(l,t);for(let d=0;d<n&&o[d]>1e-6;d++){let g=h*o[d]*(d?2:1),w=6*(n*l+d),k=6*d;for(let S=0;S<6;S++)i[k+S]+=g*r[w+S]}}}return i.map(l=>l/c)}function $u(r,e){let t=Math.min(e.length-1,Math.ceil(8+6*Math.sqrt(r))),n=0;for(let o=t+8;o>0;o--)n=r/(2*o+r*n),o<=t&&(e[o]=n);let s=1,i=1;for(let o=1;o<=t;o++)s*=e[o],e[o]=s,i+=2*s;e[0]=1;for(let o=0;o<=t;o++)e[o]/=i;e.fill(0,t+1)}function Hu(r,e,t,n){let s=Co(n),i=n/2;for(;i>1&&t.subarray(6*i-6,6*i).every(o=>Math.abs(o)<1e-6);)i-=1;for(let o=0;o<n;o++){let c=0,l=0,f=0;for(let h=0,d=0,g=0;h<i;h++,d=(d+o)%n,g+=6){let w=s[d],k=s[(d+.75*n)%n];c+=t[g]*w+t[g+3]*k,l+=t[g+1]*w+t[g+4]*k,f+=t[g+2]*w+t[g+5]*k}[c,l,f].forEach((h,d)=>{r[e+4*o+d]=Gu(h)})}}var Uo=new Float32Array(1),Bu=new Uint32Array(Uo.buffer);function Gu(r){return Uo[0]=Math.max(r,0),Math.max(0,Math.min(31743,(Bu[0]+4096>>>13)-114688))}var[Do,$o,vs]=["uniform","storage","read-only-storage"],or=class r{static async make(e,{harmonics:t,points:n}){let s=new r,{device:i,pipelines:o,bandPixels:c}=e;return Object.assign(s,{device:i,engine:e,rest:null}),s.harmonics=te(i,t??4*n.length,void 0,"the asset's visibility"),s.columns=te(i,4*zt*c),s.record=te(i,We("LobeLight"),GPUBufferUsage.UNIFORM),s.layouts=[Re(i,{0:Do}),Re(i,{0:$o,1:Do}),Re(i,{0:vs,1:vs,2:vs,3:$o})],s.tell=await o.get(gt.columns,"tell_visibility",s.layouts),s.sampler=i.createSampler({addressModeU:"repeat",magFilter:"linear",minFilter:"linear"}),s}set({rest:e,turn:t,radiance:n}){let{device:s}=this,{texels:i,width:o,height:c,levels:l,unit:f}=e;this.rest!==e&&(this.texture?.destroy(),this.texture=s.createTexture({size:[o,c,l],format:"rgba16float",usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST}),s.queue.writeTexture({texture:this.texture},i,{bytesPerRow:8*o,rowsPerImage:c},[o,c,l]),this.rest=e),s.queue.writeBuffer(this.record,0,ae("LobeLight",{colour:n.map(h=>h*f),levels:l,turn:[Math.cos(t),Math.sin(t)],least_kappa:.25,an_octave:2}))}run(e,{count:t},n){let{engine:{frameRecord:s,band:i,viewRecord:o,geometry:c},device:l,layouts:f}=this;this.groups??=[[s],[i,o],[t,c[1],this.harmonics,this.columns]].map((h,d)=>Oe(l,f[d],h)),ue(e,this.tell,this.groups,n)}delete(){for(let e of[this.harmonics,this.columns,this.record,this.texture])e?.destroy()}},ar=class extends qt{static async make(e,t,n,s,i){let{environment:o}=n,c=o.harmonics?zt:0,l=await super.of(e,t,nr({...n,planes:o.planes},o,o.inputs,c),s,{constants:{RNA_LOBES:o.lobes,RNA_IS_FIBER:+(n.kind==="fiber"),RNA_VISIBILITY_GROUPS:c/4},parts:[n.kind],kernel:gt.lobes,entryPoint:"light_by_lobes"});return Object.assign(l,{shared:i})}run(e,t,n){let{shared:s,device:i,pipeline:o}=this;if(s.run(e,t,n),this.texture!==s.texture){this.texture=s.texture;let c=[{buffer:s.record},s.texture.createView({dimension:"2d-array"}),s.sampler];this.lit=i.createBindGroup({layout:o.getBindGroupLayout(2),entries:c.map((l,f)=>({binding:f,resource:l}))})}this.dispatch(e,[t.rows,t.answers,t.count,s.columns],n,[this.lit])}};var dn=1<<17,Zu=["transport","emission","environment"],cr=class r{static async open(e){let t=new r,n=await go();Object.assign(t,{canvas:e,device:n,parts:[],lost:!1,bandPixels:dn}),n.lost.then(({reason:i,message:o})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${o||i})`)}),n.addEventListener("uncapturederror",({error:i})=>{t.error??=i}),t.context=e.getContext("webgpu");let s=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:n,format:s,alphaMode:"opaque",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new ir(n),t.compiled=t._compile(s),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,n=await Qn(t,gt.show),[s,i,o]=["uniform","storage","read-only-storage"],c=Re(t,{0:i,1:s});this.rayLayout=[Re(t,{0:s,4:o,5:o}),c,Re(t,{0:o,1:o,2:o,3:o,4:o})],this.queueLayout=[Re(t,{0:s,2:i}),c,Re(t,{0:i,1:i,2:i})],this.lookLayout=[...this.queueLayout.slice(0,2),Re(t,{0:i,1:i})];let[l,f,h,d,g,w]=await Promise.all([...["begin","gather","scatter"].map(k=>this.pipelines.get(gt.queue,k,this.queueLayout)),...["remember","smooth_edges"].map(k=>this.pipelines.get(gt.look,k,this.lookLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:n,entryPoint:"corner"},fragment:{module:n,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:f,scatter:h,remember:d,smooth:g},shown:w}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=te(e,ae("Frame",{}),t),this.viewRecord=te(e,We("View"),t),this.showRecord=te(e,We("Show"),t),this.band=te(e,We("Pixel")*dn),this.queue={rows:te(e,We("RnaRow")*dn),answers:te(e,32*dn),count:te(e,4*(dn+4))},this._bind()}async setAsset(e,t){let{device:n,pipelines:s}=this;this._deleteAsset();let i=(g,w)=>te(n,g,void 0,`the asset's ${w}`);this.geometry=[i(e.nodes,"hierarchy"),i(e.primitives,"geometry"),i(e.points,"geometry"),i(Yu(e.extent),"geometry"),i(e.normals,"geometry")],this.lightsAt=e.table.length/4,this.table=te(n,4*e.table.length+We("Light")),n.queue.writeBuffer(this.table,0,e.table),this.arrays=e,this._storeImages(),await this.compiled,this.raySources=sr({hasSegments:e.strands>0,hasTextures:e.hasTextures});let{hit:o,light:c}=this.raySources,l=t.every(({environment:g})=>g);this.lobeLight=l?await or.make(this,e):null;let[f,h,...d]=await Promise.all([s.get(o,"trace_pixels",this.rayLayout),s.get(c,"light_pixels",this.rayLayout),...t.map(g=>this._makePart(g))]);Object.assign(this,{parts:d,hasLobes:l}),this.kernels={hit:f,light:h,...this.queueKernels},this._makeSums()}async _makePart(e){let{device:t,pipelines:n}=this,s=g=>[0,1,2].map(w=>te(t,So(g,w),void 0,"a plane of features")),i=s(e.planes),{environment:o}=e,c=this.lobeLight&&o.planes!==e.planes?s(o.planes):null,l=(g,w)=>qt.make(t,n,e,g,w,i),[f,h,d]=await Promise.all([l(e.transport,e.inputs),e.emission&&l(e.emission,e.emission.inputs),this.lobeLight&&ar.make(t,n,e,c??i,this.lobeLight)]);return{planes:[...i,...c??[]],transport:f,emission:h,environment:d}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=te(this.device,4*(e.length+t.length),void 0,"the environment"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let n=e*t;this.target={width:e,height:t},!(this.sums&&n<=this.capacity&&n*8>=this.capacity)&&(this.capacity=n,this._makeSums())}_makeSums(){if(!this.capacity)return;for(let n of[this.sums,this.firstLook,this.seen])n?.destroy();let e=n=>te(this.device,16*n,void 0,"the picture"),t=this.hasLobes?this.capacity:1;Object.assign(this,{sums:e(this.capacity),firstLook:e(t),seen:e(t)}),this._bind()}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:n,queue:s}=this,i=Oe(e,t[1],{0:this.band,1:this.viewRecord}),o=Oe(e,n[2],[s.rows,s.answers,s.count]),c=Oe(e,n[0],{0:this.frameRecord,2:this.sums});this.groups={rays:[Oe(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),i,Oe(e,t[2],this.geometry)],queue:[c,i,o],look:[c,i,Oe(e,this.lookLayout[2],[this.seen,this.firstLook])],show:hn(e,this.shown,0,[this.showRecord,this.sums,this.firstLook])}}trace(e,t,n,s){let{width:i}=this.target;this.span={first:n*i,pixels:(s-n)*i,jitter:e.jitter??1,shift:e.shift??[0,0]},this._writeFrame(e,t),this._writeView({}),this._run(o=>ue(o,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:n}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:n},this._writeView(this.view),this._run(s=>{ue(s,this.kernels.light,this.groups.rays,this.span.pixels),ue(s,this.kernels.begin,this.groups.queue,this.span.pixels)}),e.kind==="mirror"&&this.lobeLight.set(e),this._decode(e.kind==="mirror"?"environment":"transport")}emission(){this._decode("emission")}remember(){this._run(e=>ue(e,this.kernels.remember,this.groups.look,this.span.pixels))}smoothEdges(e,t){this._writeView({shares:e,isFirst:t}),this._run(n=>ue(n,this.kernels.smooth,this.groups.look,this.span.pixels))}show({rounds:e,firstLook:t,exposure:n,backdrop:s,filmic:i,spread:o}){let{width:c,height:l}=this.target,{canvas:f,device:h}=this;h.queue.writeBuffer(this.showRecord,0,ae("Show",{size:[f.width,f.height],picture:[c,l],backdrop:s,rounds:e,exposure:n,filmic:Number(i),spread:o,first_look:t}));let d=h.createCommandEncoder(),g=this.context.getCurrentTexture().createView(),w=d.beginRenderPass({colorAttachments:[{view:g,loadOp:"clear",storeOp:"store"}]});w.setPipeline(this.shown),w.setBindGroup(0,this.groups.show),w.draw(3),w.end(),h.queue.submit([d.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await pn(this.device,this.sums,16*e*t))}_decode(e){for(let[t,n]of this.parts.entries()){let s=n[e];s&&(this._writeView({...this.view,part:t+1,form:Zu.indexOf(e)}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(i=>{ue(i,this.kernels.gather,this.groups.queue,this.span.pixels),s.run(i,this.queue,this.span.pixels),ue(i,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),n=t.beginComputePass();e(n),n.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:n,stepY:s},i){let{lightsAt:o,arrays:c,span:l,target:f}=this;this.device.queue.writeBuffer(this.frameRecord,0,ae("Frame",{camera:e,corner:t,step_x:n,step_y:s,width:f.width,paths:l.pixels,sample:i,branches:1,depth:1,rays:ce.CAMERA_RAY,flags:c.transmits?ce.TRANSMITS:0,textures:c.texturesAt,lights:o}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:n=[0,0,0],ground:s,isFirst:i=!1,countsCoverage:o=!1,part:c=0,form:l=0,shares:f=1}){let{first:h,jitter:d,shift:g=[0,0]}=this.span,{width:w,height:k}=this.target,S=s&&{ground:s.height,ground_colour:s.colour,ground_size:s.size,middle:[s.x,s.z]};this.device.queue.writeBuffer(this.viewRecord,0,ae("View",{first:h,jitter:d,kind:Sr[e],is_first:Number(i),direction:t,counts_coverage:Number(o),colour:n,part:c,form:l,shift:g,pixels:w*k,shares:f,...S}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:n,height:s,total:i,places:o}=this.environment,c={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=Zs("image",{colour:t,...c,total:i,rows:s,columns:n});this.device.queue.writeBuffer(this.table,16*this.lightsAt,ae("Light",{kind:ce.IMAGE,group:ce.NONE,numbers:l,places:o.map(f=>f+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();this.lobeLight?.delete();for(let{planes:e,...t}of this.parts){e.forEach(n=>n.destroy());for(let n of Object.values(t))n?.delete()}this.parts=[],this.geometry=this.images=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}},Yu=r=>ae("RnaInstance",{to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1,root:1,rays:ce.CAMERA_RAY,extent:r});function Ho(r,e){let{cameraControls:t,disableZoom:n,wheelZoom:s}=r.settings;if(!t||e.type!=="wheel")return t;let i=r.place.getRootNode().activeElement===r.canvas;return!n&&(s==="always"||i||e.ctrlKey||e.metaKey)}function Bo(r){let e=(t,n)=>(...s)=>{r.settings[n]||(t(...s),r.isTouched=!0,r.viewer.restart(s.at(-1)===!0),r.tell("camera",{byUser:!0}))};return{orbit:e((t,n)=>r.orbit.turn(t,n)),pan:e((t,n)=>r.orbit.pan(t,n),"disablePan"),zoom:e(t=>r.orbit.zoom(t),"disableZoom"),light:(t,n,s)=>{if(r.settings.disableLight)return;let i=Ln(r.lighting.rotation+t*180/Math.PI),o=Ps(r.lighting.sunHeight+n*180/Math.PI,-10,90);r.setLight({rotation:i,sunHeight:o},{moving:s===!0,byUser:!0})},settle:()=>r.viewer.moving&&r.viewer.restart(),reset:()=>r.reset()}}var Go=[[1,3],[-3,1],[3,-1],[-1,-3]].map(r=>r.map(e=>e/8)),Vu={kind:"sun",direction:[0,1,0],colour:[0,0,0]},lr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{engine:e,canvas:t,orbit:n}),Object.assign(this,{lights:[],firstLights:null,ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,ready:!1,stopped:!1,moving:!1,resting:!1,backdrop:[0,0,0],stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1){this.moving=e,Object.assign(this.stats,{rounds:0,scale:0}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}rest(e){this.resting=e,e||this.rouse?.()}stop(){return this.stopped=!0,this.rest(!1),this.pause(),this.wake?.(),this.running}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await new Promise(t=>this.addEventListener("shown",t,{once:!0}))}show(){if(!this.shown)return;let{rounds:e,firstLook:t}=this.shown,n=this.denoise&&e<12&&!t;this.engine.show({rounds:e,firstLook:t,exposure:2**this.exposure,backdrop:this.backdrop,filmic:this.view==="filmic",spread:n?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let n=t===1&&!this.moving?this.rounds:+!this.firstLights;if(!await this._stage(e,t,n)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,(this.firstLights??this.lights).length),t=1;for(;t<16&&e*this.msPerPixel/t**2>110;)t*=2;let n=[t];for(;t>1;)n.push(t=t>4?t/4:1);return n}async _stage(e,t,n){let{engine:s,canvas:i}=this,o=Math.ceil(i.width/t),c=Math.ceil(i.height/t);this.shown=null,s.resize(o,c);let l={...this.orbit.camera(o,c),jitter:this.jitter},{firstLights:f}=this;if(f){let h=performance.now();if(!await this._look(e,{...l,jitter:0}))return!1;this._present(0,t,1),this._measure(performance.now()-h,o*c,f.length)}else if(!this.hasShown){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(1,t,0)}for(let h=0;h<n;h++){let d=performance.now();if(!await this._round(e,l,h,this.lights))return!1;let g=performance.now()-d;this._present(h+1,t,f?Wu(h+1):0),this._measure(g,o*c,this.lights.length),t===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*g:g)}return!0}_round(e,t,n,s){return this._bands(e,s.length,(i,o)=>this._band(t,n,s,i,o))}async _look(e,t){let{engine:n,firstLights:s}=this;return await this._bands(e,s.length,(o,c)=>{this._band(t,0,s,o,c),n.remember()})?this._bands(e,1,(o,c)=>Go.forEach((l,f)=>{n.trace({...t,shift:l},0,o,c),n.smoothEdges(Go.length,f===0)})):!1}async _bands(e,t,n){let{engine:s}=this,{width:i,height:o}=s.target,c=this.msPerPixel*i*Math.max(1,t),l=Math.max(1,Math.min(o,Math.floor(120/c),Math.floor(s.bandPixels/i)));for(let f=0;f<o;f+=l)if(this.resting&&await new Promise(h=>{this.rouse=h}),n(f,Math.min(o,f+l)),await s.done(),e!==this.generation||this.stopped||s.lost)return!1;return!0}_band(e,t,n,s,i){let{engine:o}=this;o.trace(e,t,s,i),(n.length?n:[Vu]).forEach((l,f)=>o.light({...l,ground:this.ground},{isFirst:t===0&&f===0,countsCoverage:f===0})),o.emits&&o.emission()}_present(e,t,n){this.shown={rounds:e,firstLook:n},this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:e,scale:t}),this.dispatchEvent(new Event("shown"))}_measure(e,t,n){let s=e/(t*Math.max(1,n));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,s):.5*(this.msPerPixel+s)}},Wu=r=>Math.max(0,1-r/64)/(1+r/8);var Xu=22e5,Ku=4,Ju=6e4,ur=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{place:e,notices:t,settings:n,losses:0,lives:0,isResting:!1}),this.look={exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1},new ResizeObserver(()=>this.resize()).observe(e)}begin(){let{samples:e,jitter:t}=this.settings;return Object.assign(this.look,e&&{rounds:e},t!==null&&{jitter:t}),this.replace()}end(){this.lives+=1,this.begun=Promise.resolve(!1),this.viewer?.stop(),this.engine?.close(),Object.assign(this,{viewer:null,engine:null})}replace(){this.end(),this.since=performance.now();let e=this._begin().then(()=>e===this.begun?!!this.engine:this.begun,t=>e!==this.begun?this.begun:(this.end(),this.failed(t,"engine"),!1));return this.begun=e}async _begin(){let e=this.lives,t=document.createElement("canvas"),n=await cr.open(t);if(e!==this.lives)return n.close();Object.assign(this,{engine:n,canvas:t}),this.place.replaceChildren(t),n.onlost=s=>this._lost(n,s),this.viewer=Object.assign(new lr(n,t,this.orbit),this.look,{resting:this.isResting}),this.viewer.addEventListener("shown",()=>this.pictured()),this.viewer.addEventListener("failed",({error:s})=>this._lost(n,qo(s))),performance.mark("engine"),xo(t,Bo(this),s=>Ho(this,s)),this.tell("engine"),this.resize(),await this.restore(n)}rest(e){this.isResting=e,this.viewer?.rest(e)}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.place,n=this.settings.pixelRatio??Math.min(devicePixelRatio,2),s=Math.min(n,Math.sqrt(Xu/Math.max(1,e*t))),i=Math.max(1,Math.round(e*s)),o=Math.max(1,Math.round(t*s));this.canvas.width===i&&this.canvas.height===o||(Object.assign(this.canvas,{width:i,height:o}),this.resized(),this.viewer.restart())}get wgsl(){return{compose:rr,sharedFiles:ot,rayKernels:sr}}reader(){return this.viewer.pause(),new er(this.engine)}screenshot(e="image/png",t=void 0){return this.viewer.show(),new Promise(n=>this.canvas.toBlob(n,e,t))}async _lost(e,t){if(e===this.engine){if(this.losses=performance.now()-this.since>Ju?1:this.losses+1,this.losses>=Ku)return this.end(),this.failed(new B(`${t}, ${this.losses} times`),"engine");this.notices.say(`${t}; starting again`,!0,"engine"),await this.replace()&&this.notices.say(null,!1,"engine")}}tell(e,t){this.dispatchEvent(Object.assign(new Event(e),t))}failed(e,t){jo(e)||console.error(e),this.notices.say(qo(e),!1,t),this.failures=(this.failures??0)+1,this.tell("failed",{error:e,about:t})}},jo=r=>r instanceof Xt||r instanceof B,qo=r=>jo(r)?r.message:`this did not work: ${r.message??r}`;var Me=[64,128],Yo=[64,128],Qu=512,ef=4,Zo=8,tf=Math.cos(15*Math.PI/180),nf=200,_t=Me[0]*Me[1];function Vo(r){let e=rf(r),t=sf(e),{flux:n,sums:s,directions:i}=of(e.rgb,t),{excess:o,share:c}=af(n),l=cf(o),f=new Uint8Array(_t);for(let g of l)for(let w of g)f[w]=1;let{radiance:h,up:d}=hf(e.rgb,t,g=>f[g]?1-c[g]:1);return{lights:l.map(g=>ff(g,o,w=>s[w]*c[Math.floor(w/3)],i)),up:d,rest:Fo(h,Yo)}}function rf({rgb:r,width:e,height:t}){let n=Math.ceil(Qu/e);if(n<=1)return{rgb:r,width:e,height:t};let s=n*e,i=n*t,o=new Float32Array(3*s*i);for(let c=0;c<i;c++){let l=(c+.5)/n-.5,f=Math.floor(l),h=l-f,d=[Math.max(f,0),Math.min(f+1,t-1)];for(let g=0;g<s;g++){let w=(g+.5)/n-.5,k=Math.floor(w),S=w-k,L=[(k+e)%e,(k+1)%e];for(let Z=0;Z<3;Z++){let G=(Ge,qe)=>r[3*(d[Ge]*e+L[qe])+Z],W=G(0,0)+S*(G(0,1)-G(0,0)),ne=G(1,0)+S*(G(1,1)-G(1,0));o[3*(c*s+g)+Z]=W+h*(ne-W)}}}return{rgb:o,width:s,height:i}}function sf({width:r,height:e}){let t=new Float64Array(e),n=new Int32Array(e);for(let s=0;s<e;s++){let i=Math.PI*(s+.5)/e;t[s]=2*Math.PI/r*(Math.cos(Math.PI*s/e)-Math.cos(Math.PI*(s+1)/e)),n[s]=Math.min(Me[0]-1,Math.floor((1-Math.cos(i))/2*Me[0]))}return{width:r,height:e,solid:t,rows:n}}var Wo=({rows:r,width:e},t,n)=>r[t]*Me[1]+Math.floor(n/e*Me[1]);function of(r,e){let t=new Float64Array(3*_t),n=new Float64Array(_t),s=new Float64Array(3*_t);for(let o=0,c=0;o<e.height;o++){let l=Math.PI*(o+.5)/e.height,f=e.solid[o],h=Math.sin(l),d=Math.cos(l);for(let g=0;g<e.width;g++,c+=3){let w=Wo(e,o,g),k=2*Math.PI*(g+.5)/e.width-Math.PI;n[w]+=f;for(let L=0;L<3;L++)t[3*w+L]+=r[c+L]*f;let S=Le(r,c/3)*f;s[3*w]+=S*h*Math.sin(k),s[3*w+1]+=S*d,s[3*w+2]-=S*h*Math.cos(k)}}return{flux:t.map((o,c)=>o/n[Math.floor(c/3)]*(4*Math.PI/_t)),sums:t,directions:s}}var Le=(r,e)=>(r[3*e]+r[3*e+1]+r[3*e+2])/3;function af(r){let e=ef*r.reduce((n,s)=>n+s,0)/r.length,t=Float64Array.from({length:_t},(n,s)=>Math.max(0,1-e/Math.max(Le(r,s),1e-30)));return{share:t,excess:r.map((n,s)=>n*t[Math.floor(s/3)])}}function mn(r){let e=1-2*(Math.floor(r/Me[1])+.5)/Me[0],t=Math.sqrt(1-e*e),n=2*Math.PI*(r%Me[1]+.5)/Me[1]-Math.PI;return[t*Math.sin(n),e,-t*Math.cos(n)]}var ws=(r,e)=>r[0]*e[0]+r[1]*e[1]+r[2]*e[2];function ys(r,e){let t=[0,0,0],n=0;for(let i of r){let o=Le(e,i);n+=o,mn(i).forEach((c,l)=>{t[l]+=o*c})}let s=Math.hypot(...t)||1;return{flux:n,size:s,direction:t.map(i=>i/s)}}function cf(r){let e=[];for(let s=0;s<_t;s++)Le(r,s)>0&&e.push(s);e.sort((s,i)=>Le(r,i)-Le(r,s));let t=[],n=s=>e.filter(i=>ws(mn(i),s)>tf);for(;e.length&&t.length<Zo;){let i=e.slice(0,nf).map(c=>ys(n(mn(c)),r)).reduce((c,l)=>l.flux>c.flux?l:c),o=new Set(n(i.direction));t.push([...o]),e=e.filter(c=>!o.has(c))}for(;t.length&&t.length<Zo&&lf(t,r););return t}function lf(r,e){let t=d=>{let{flux:g,size:w}=ys(d,e);return g-w},n=r.reduce((d,g)=>t(g)>t(d)?g:d),{direction:s}=ys(n,e),i=uf(n,e,s),o=n.map(d=>ws(mn(d),i)),c=0,l=0;n.forEach((d,g)=>{c+=Le(e,d)*o[g],l+=Le(e,d)});let[f,h]=[!0,!1].map(d=>n.filter((g,w)=>o[w]*l>c===d));return!f.length||!h.length?!1:(r.splice(r.indexOf(n),1,f,h),!0)}function uf(r,e,t){let n=[[0,0,0],[0,0,0],[0,0,0]];for(let i of r){let o=mn(i).map((l,f)=>l-t[f]),c=Le(e,i);for(let l=0;l<3;l++)for(let f=0;f<3;f++)n[l][f]+=c*o[l]*o[f]}let s=[.6,.5,.62];for(let i=0;i<60;i++){let o=n.map(l=>ws(l,s)),c=Math.hypot(...o);if(!c)break;s=o.map(l=>l/c)}return s}function ff(r,e,t,n){let s=[0,1,2].map(c=>r.reduce((l,f)=>l+t(3*f+c),0)),i=[0,0,0];for(let c of r){let l=n.subarray(3*c,3*c+3),f=Le(e,c)/Math.hypot(...l);l.forEach((h,d)=>{i[d]+=f*h})}let o=Math.hypot(...i);return{direction:i.map(c=>c/o),colour:s}}function hf(r,e,t){let[n,s]=Yo,i=new Float64Array(3*n*s),o=new Float64Array(n*s),c=[0,0,0];for(let l=0,f=0;l<e.height;l++){let h=Math.max(0,Math.cos(Math.PI*(l+.5)/e.height)),d=e.solid[l];for(let g=0;g<e.width;g++,f+=3){let w=Math.floor(l/e.height*n)*s+Math.floor(g/e.width*s),k=d*t(Wo(e,l,g));o[w]+=d;for(let S=0;S<3;S++)i[3*w+S]+=k*r[f+S],c[S]+=k*h*r[f+S]}}return{radiance:i.map((l,f)=>l/o[Math.floor(f/3)]),up:c}}var pf={studio:["Studio",si],white:["White from all sides",()=>Gn([1,1,1])]},df=[1.06,1,.9],fr=Math.PI/180,hr=class{constructor(){this.images=new Map(Object.entries(pf).map(([e,[t,n]])=>[e,{label:t,make:n}])),this.choice="studio",this.turntable=0,this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:[],imageTurn:0})}add(e,t){let n=`image-${this.images.size}`;return this.images.set(n,{label:e,make:()=>t}),n}tables(){let e=this.images.get(this.choice);return e.tables??=ri(e.make()),e.tables}firstLights(){if(!(this.strength>0))return null;let e=this.images.get(this.choice),t=this._turn(),{lights:n,rest:s,up:i}=e.first??=Vo(e.make()),o=l=>l.map(f=>f*this.strength),c=n.map(({direction:l,colour:f})=>({kind:"sun",direction:Xo(l,t),colour:o(f)}));return[...this._suns(),...c,{kind:"mirror",colour:o(i),radiance:o([1,1,1]),turn:t,rest:s}]}lights(){let e=this._suns(),t=[0,0,0];for(let{direction:n,colour:s}of e)s.forEach((i,o)=>{t[o]+=i*Math.max(0,n[1])});if(this.strength>0){let n=[this.strength,this.strength,this.strength],s=this._turn();e.push({kind:"environment",colour:n,angle:s},{kind:"aroundPoint",colour:n,angle:s}),this.tables().up.forEach((i,o)=>{t[o]+=i*this.strength})}return{lights:e,irradiance:t}}_turn(){return(this.rotation+this.turntable+this.imageTurn)*fr}_suns(){let e=(this.rotation+this.turntable)*fr;return(this.suns??[this._sun()]).filter(({irradiance:t})=>t.some(n=>n>0)).map(({direction:t,irradiance:n})=>({kind:"sun",direction:Xo(t,e),colour:n}))}_sun(){let e=this.sunHeight*fr,t=this.sunAzimuth*fr;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:df.map(n=>n*this.sun)}}};function Xo([r,e,t],n){let s=Math.cos(n),i=Math.sin(n),o=Math.hypot(r,e,t);return[(s*r+i*t)/o,e/o,(s*t-i*r)/o]}var Ko=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),mf=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],gf=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function _f(r){let e=mf.map(t=>{let n=1.461926*Ko(t,r);return(n*(n+.0245786)-90537e-9)/(n*(.983729*n+.432951)+.238081)});return gf.map(t=>Ko(t,e))}function Jo(r){let e=[...r];for(let t=0;t<60;t++){let n=_f(e);e=e.map((s,i)=>s*Math.min(2,Math.max(.5,r[i]/Math.max(n[i],1e-6))))}return e}var pr=class extends ur{constructor(e,t,n){super(e,t,n),Object.assign(this,{orbit:new Pn,lighting:new hr,labels:{},ground:!1,scene:null,isTouched:!1}),Object.assign(this,{opened:null,shown:null,loading:null,lit:Promise.resolve(),placing:Promise.resolve()})}close(){this.loading?.abort(),this.end()}async open(e){this.loading?.abort();let t=this.loading=new AbortController,{signal:n}=t;try{this.notices.say(null,!1,"asset"),this.tell("loading");let s=(c,l)=>n.aborted||this.tell("progress",{got:c,all:l}),i=e instanceof Blob?new bt(e,e.name):await On.open(e,s,n,this.labels[Kt(e)]),o=await Dt.open(i);n.throwIfAborted(),await this._offerPoster(o),await this._show(o,this.settings.tier,!0,n)}catch(s){n.aborted||this.failed(s,"asset")}finally{this.loading===t&&(this.loading=null,this.tell("ended"))}}async switchTier(e){try{this.notices.say(null,!1,"asset"),await this._show(this.opened,e,!1)}catch(t){this.failed(t,"asset")}finally{this.tell("ended")}}async openScene(e){try{let t=JSON.parse(new TextDecoder().decode(await xs(e))),{radiance:n,image:s}=t.environment??{},i=o=>new URL(Ai(o),new URL(e,document.baseURI)).href;if(t.asset&&(t.asset=i(t.asset)),n&&(t.environment.key=this.lighting.add("The scene's",Gn(n))),s){let o=this.labels[s]??s;t.environment.key=this.lighting.add(o,Kr(await xs(i(s)),s))}return this.scene=t,this.reset(),t}catch(t){return this.failed(t,"scene"),null}}openImage(e,t){return this.lit=this._openImage(e,t)}async _openImage(e,t){let n=this.askedImage={};try{this.notices.say(null,!1,"light");let s=e instanceof Blob?await e.arrayBuffer():await xs(e);if(n!==this.askedImage)return;this.setLight({choice:this.lighting.add(this.labels[t]??t,Kr(s,t))})}catch(s){n===this.askedImage&&this.failed(s,"light")}}chooseImage(e){this.askedImage=null,this.setLight({choice:e})}setLight(e,{moving:t=!1,byUser:n=!1}={}){Object.assign(this.lighting,e),this.tell("set"),this.tell("light",{byUser:n}),this.changed(t)}changed(e=!1){if(!this.viewer)return;let{lights:t,irradiance:n}=this.lighting.lights();t.some(({kind:s})=>s==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.backdrop=mo(this.place),this.viewer.lights=t,this.viewer.firstLights=this.engine.hasLobes?this.lighting.firstLights():null,this.viewer.ground=this._ground(n),this.viewer.restart(e)}reset(){let{ground:e,exposure:t,view:n}=this.scene??{},{settings:s}=this;this.placeCamera(),this.placeLights(),this.ground=s.ground??e??this.ground,this.setExposure(s.exposure??t??this.look.exposure),this.setView(s.viewTransform??n??this.look.view)}placeCamera(){let{position:e,look_at:t,vertical_fov_deg:n}=this.scene?.camera??{},{settings:s}=this,i=[e?Us(e,t,n):{},s.cameraOrbit??{},{target:s.cameraTarget,fov:s.fieldOfView}];this.isTouched=!1;let{width:o,height:c}=this.canvas??{width:1,height:1};this.orbit.place(i,this.box,o/c,s.autoRotate),this.tell("camera",{byUser:!1}),this.viewer?.restart()}placeLights(){let{suns:e,environment:t}=this.scene??{},{sun:n,lightRotation:s,environmentIntensity:i}=this.settings,{lighting:o}=this;if(o.reset(),e&&(o.suns=e),t){let{key:c,strength:l=1,rotation_deg:f=0}=t,h=!this.settings.environment&&c||o.choice;Object.assign(o,{choice:h,strength:l,imageTurn:f})}n&&Object.assign(o,n,{suns:null}),this.setLight({rotation:Ln(s??0),strength:i??o.strength})}turnTable(e,t){this.orbit.turntable=-e,this.lighting.turntable=-e*180/Math.PI,this.changed(t)}setExposure(e,t=!0){this._setLook({exposure:e},t&&this.ground)}setView(e){this._setLook({view:e},this.ground)}setDenoise(e){this._setLook({denoise:e})}setGround(e){this.ground=e,this.changed()}_setLook(e,t=!1){Object.assign(this.look,e),Object.assign(this.viewer??{},e),this.tell("set"),t&&this.changed(),this.viewer?.show()}async _show(e,t,n,s){if(!await this.begun)return;let i=await e.load(t,{wantsLobes:this.settings.firstLook!=="off"});e.forget(),performance.mark("package"),await this.lit,await this.begun&&(this.placing=this.placing.catch(()=>{}).then(()=>this._place(e,i,n,s)),await this.placing)}async _place(e,t,n,s){if(s?.throwIfAborted(),!this.viewer||!n&&this.opened!==e)return;n&&(this.viewer.hasShown=!1),this.viewer.pause();let i=n?Bn(t.parts):this.arrays;if(performance.mark("hierarchy"),!await this._upload(i,t))return;performance.mark("asset"),Object.assign(this,{opened:e,shown:t,arrays:i,box:i.box,isNew:n}),n&&this.scene?this.reset():n&&this.placeCamera();let o=[...e.manifest.warnings,...t.warnings];o.length&&this.notices.say(o.join("; "),!0,"asset"),this.tell("package",{opened:e,shown:t}),this.viewer.stats.ms=0,this.changed(),this.viewer.start()}async _upload(e,{parts:t}){for(;await this.begun&&this.engine;){let{engine:n}=this;try{if(await n.setAsset(e,t),n===this.engine)return!0}catch(s){if(n===this.engine)throw s}}return!1}async restore(e){this.uploaded=null,this.shown&&(this.viewer.hasShown=!0,await e.setAsset(this.arrays,this.shown.parts),this.changed(),this.viewer?.start())}resized(){this.shown&&!this.isTouched&&this.placeCamera()}pictured(){this.tell("shown"),this.isNew&&(this.isNew=!1,this.tell("load"))}async _offerPoster(e){try{this.tell("poster",{blob:await e.posterImage()})}catch{}}_ground(e){if(!this.ground||!this.box)return null;let{view:t,exposure:n}=this.look,{backdrop:s}=this.viewer,i=t==="filmic"?Jo(s):s,{min:o,max:c}=this.box,l=Math.hypot(...c.map((f,h)=>f-o[h]));return{height:o[1]-1e-4*l,x:(o[0]+c[0])/2,z:(o[2]+c[2])/2,size:2*l,colour:i.map((f,h)=>e[h]>0?f/e[h]/2**n:0)}}};async function xs(r){let e=await fetch(r).catch(()=>null);if(!e?.ok)throw new B(`cannot load ${r}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var dr=class{constructor(e){Object.assign(this,{stage:e,angle:0,isOn:!1,isTurning:!1,delay:3e3,speed:30}),e.addEventListener("shown",()=>this._next());for(let t of["load","camera","light"])e.addEventListener(t,()=>this.wait())}wait(){clearTimeout(this.timer);let e=this.isTurning;this.isTurning=!1,this.isOn?this.timer=setTimeout(()=>this._start(),this.delay):e&&this.stage.viewer?.restart()}switch(e){this.isOn=e,this.wait()}set(e){this.angle=e,this.stage.turnTable(e,this.isTurning)}_start(){Object.assign(this,{isTurning:!0,last:performance.now()}),this._next()}_next(){!this.isTurning||this.isAsked||(this.isAsked=!0,requestAnimationFrame(e=>{if(this.isAsked=!1,!this.isTurning)return;let t=Math.min(.25,Math.max(0,e-this.last)/1e3);this.last=e,this.set(this.angle+t*this.speed*Math.PI/180)}))}};var vf=["studio","white"],yf="50% 0px",wf=500,mr=class extends HTMLElement{static observedAttributes=Object.keys(en);constructor(){super();let e=Hs(this),t=n=>e.getElementById(n);this.parts={view:t("view"),poster:t("poster"),image:e.querySelector("img"),loading:t("loading"),bar:t("bar"),bytes:t("bytes"),status:t("status")},this.settings=Object.fromEntries(Object.keys(en).map(n=>[Un(n),null])),this.notices=new Mn(t("notice")),this.stage=new pr(this.parts.view,this.notices,this.settings),this.turntable=new dr(this.stage),this.stillness=matchMedia("(prefers-reduced-motion: reduce)"),Object.assign(this,{loaded:!1,observer:null,isNear:!1,isDismissed:!1,isBegun:!1,asked:null}),this._listen()}connectedCallback(){this.stage.labels=JSON.parse(this.dataset.labels??"{}"),this.observer=new IntersectionObserver(e=>this._seen(e.at(-1).isIntersecting),{rootMargin:yf}),this.observer.observe(this),this.stillness.addEventListener("change",this.onstillness=()=>this._turn()),this._turn(),this._begin()}disconnectedCallback(){this.observer.disconnect(),this.stillness.removeEventListener("change",this.onstillness),queueMicrotask(()=>{this.isConnected||!this.isBegun||(this.stage.loading&&(this.asked=null),this.isBegun=!1,this.turntable.switch(!1),this.stage.close())})}attributeChangedCallback(e,t,n){if(t===n)return;let s=Un(e);try{this.settings[s]=n===null?null:en[e](n),this.notices.say(null,!0,e)}catch(i){this.settings[s]=null,this.notices.say(`${e}: ${i.message}`,!0,e)}this._apply(e)}get availableTiers(){return this.stage.opened?.manifest.tiers.map(({name:e})=>e)??[]}get turntableRotation(){return this.turntable.angle}resetTurntableRotation(e=0){this.turntable.set(e)}resetView(){this.stage.reset()}showPoster(){this.isDismissed=!1,this.parts.poster.hidden=!1}dismissPoster(){this.isDismissed=!0,this._begin(),this.loaded&&this._hidePoster()}async toBlob({mimeType:e="image/png",qualityArgument:t,converged:n=!1}={}){let{stage:s}=this;return!s.viewer||!this.loaded?null:(n&&await s.viewer.converged(),s.screenshot(e,t))}_seen(e){this.isNear=e,this.stage.rest(!e),this._begin()}_apply(e){let{stage:t,settings:n}=this;e==="src"&&this._begin(),e==="poster"&&this._showImage(n.poster),e==="scene"&&this.isBegun&&this._openScene(),e==="environment"&&this.isBegun&&this._light(),e==="tier"&&t.opened&&n.tier&&t.switchTier(n.tier),["camera-orbit","camera-target","field-of-view"].includes(e)&&t.placeCamera(),["sun","light-rotation","environment-intensity"].includes(e)&&t.placeLights(),e==="ground"&&t.setGround(n.ground??t.scene?.ground??!1),e==="exposure"&&t.setExposure(n.exposure??t.scene?.exposure??0),e==="view-transform"&&t.setView(n.viewTransform??t.scene?.view??"srgb"),e==="pixel-ratio"&&t.resize(),["loading","reveal"].includes(e)&&this._begin(),(e.startsWith("auto-rotate")||e==="rotation-per-second")&&this._turn(),this._describe()}_begin(){let{stage:e,settings:t}=this,n=t.reveal!=="manual"||this.isDismissed;if(this.parts.image.loading=t.loading==="eager"?"eager":"lazy",!(!this.isConnected||!this.observer||!(t.loading==="eager"||this.isNear&&n))){if(!this.isBegun&&(this.isBegun=!0,e.begin(),this._turn(),t.environment&&!this.isLit&&this._light(),t.scene))return void this._openScene();t.src!==this.asked&&this._open()}}_open(){this.asked=this.settings.src,this.asked!==null&&(this.loaded=!1,this.stage.open(this.asked))}async _openScene(){let e=this.askedScene=this.settings.scene;if(e===null)return;let t=await this.stage.openScene(e);e===this.askedScene&&(this.settings.src?this._begin():t?.asset&&this.stage.open(t.asset))}_light(){let{environment:e}=this.settings;this.isLit=!0,e!==null&&!vf.includes(e)?this.stage.openImage(e,Kt(e)):this.stage.chooseImage(e??"studio")}_turn(){let{autoRotate:e,autoRotateDelay:t,rotationPerSecond:n}=this.settings;Object.assign(this.turntable,{delay:t??3e3,speed:n??30}),this.turntable.switch(!!e&&this.isBegun&&!this.stillness.matches)}_listen(){let{stage:e,parts:t}=this,n=(s,i)=>e.addEventListener(s,i);n("engine",()=>this._describe()),n("progress",({got:s,all:i})=>this._showProgress(s,i)),n("poster",({blob:s})=>this.settings.poster||this._showImage(s&&URL.createObjectURL(s))),n("package",()=>this._describe()),n("load",()=>{this.loaded=!0,(this.settings.reveal!=="manual"||this.isDismissed)&&this._hidePoster(),t.status.textContent=`${this._name()} is shown`,this._fire("progress",{totalProgress:1}),this._fire("load",{url:this.asked})}),n("ended",()=>{t.loading.hidden=!0}),n("failed",({error:s,about:i})=>{i==="engine"&&(t.poster.hidden=!1),this._fire("error",{type:i,message:s.message,code:s.code??null,sourceError:s})}),n("camera",({byUser:s})=>{this._fire("camera-change",{...tn(e.orbit),source:s?"user-interaction":"none"}),s&&this._speak()}),n("light",({byUser:s})=>this._fire("light-change",{...Dn(e.lighting),source:s?"user-interaction":"none"}))}_speak(){clearTimeout(this.speaking),this.speaking=setTimeout(()=>{this.parts.status.textContent=Gs(this.stage.orbit)},wf)}_showProgress(e,t){let{loading:n,bar:s,bytes:i}=this.parts;n.hidden=!1,t?Object.assign(s,{max:Math.max(t,e),value:e}):s.removeAttribute("value"),i.textContent=t?`${ut(e)} of ${ut(Math.max(t,e))}`:ut(e),this._fire("progress",{totalProgress:t?Math.min(.99,e/t):0})}_showImage(e){let{image:t,poster:n}=this.parts;t.src.startsWith("blob:")&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=e:t.removeAttribute("src"),e&&(n.hidden=!1)}_hidePoster(){let{poster:e}=this.parts;e.hidden||(e.hidden=!0,this._fire("poster-dismissed"))}_name(){return this.settings.alt??this.stage.opened?.manifest.name??"A relightable asset"}_describe(){let{canvas:e}=this.stage,{cameraControls:t,touchAction:n}=this.settings;if(this.parts.image.alt=this._name(),!e)return;e.style.touchAction=t?n??"pan-y":"auto";let s=t?{role:"application",tabindex:0,"aria-describedby":"keys"}:{role:"img"};e.setAttribute("aria-label",this._name());for(let i of["role","tabindex","aria-describedby"])i in s?e.setAttribute(i,s[i]):e.removeAttribute(i)}_fire(e,t=null){this.dispatchEvent(new CustomEvent(e,{detail:t}))}},xf={cameraOrbit:({stage:r})=>tn(r.orbit).cameraOrbit,cameraTarget:({stage:r})=>tn(r.orbit).cameraTarget,fieldOfView:({stage:r})=>tn(r.orbit).fieldOfView,sun:({stage:r})=>Dn(r.lighting).sun,lightRotation:({stage:r})=>Dn(r.lighting).lightRotation,environmentIntensity:({stage:r})=>r.lighting.strength,exposure:({stage:r})=>r.look.exposure,viewTransform:({stage:r})=>r.look.view,tier:({stage:r,settings:e})=>r.shown?.name??e.tier};for(let[r,e]of Object.entries(en)){let t=Un(r),n=e===Ve;Object.defineProperty(mr.prototype,t,{get(){return xf[t]?.(this)??(n?this.settings[t]===!0:this.settings[t])},set(s){n?this.toggleAttribute(r,!!s):s==null?this.removeAttribute(r):this.setAttribute(r,s)},enumerable:!0,configurable:!0})}customElements.get("rna-viewer")||customElements.define("rna-viewer",mr);})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
