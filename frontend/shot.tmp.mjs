import { chromium } from 'playwright'
const url='http://127.0.0.1:9200'; const [,,role,size,scheme,...paths]=process.argv
const S={wide:{width:1440,height:900},narrow:{width:390,height:844}}
const b=await chromium.launch({executablePath:'/usr/bin/chromium',args:['--no-sandbox','--disable-gpu']})
const c=await b.newContext({viewport:S[size],colorScheme:scheme,reducedMotion:'reduce'})
await c.addCookies([{name:'soundlist_demo_part',value:role,url}])
const p=await c.newPage(); p.on('pageerror',e=>console.log('PAGEERROR',e.message)); p.on('console',m=>m.type()==='error'&&console.log('CONSOLE',m.text()))
await p.goto(url+'/sign-in'); await p.waitForTimeout(3000)
const me=await (await c.request.get(url+'/v1/me')).json(); const projects=await (await c.request.get(url+'/v1/projects')).json(); const items=projects.items??projects
const project='/projects/'+items[0].id
const contracts=await (await c.request.get(url+'/v1'+project+'/contracts')).json()
const list=await (await c.request.get(url+'/v1'+project+'/sound-list')).json()
const cue=n=>list.cues?.find(x=>x.name===n)?.id
for (const raw of paths){ const path=raw.replace('{p}',project).replace('{c}',project+'/contracts/'+contracts[0]?.id).replace(/\{cue:(\w+)\}/,(_, n)=>cue(n))
 try { await p.goto(url+path); await p.waitForLoadState('networkidle',{timeout:30000}).catch(()=>{}); await p.waitForTimeout(700)
 const name=(role+'-'+raw.replace(/[^\w]+/g,'_')+'-'+size+'-'+scheme).slice(0,90)
 await p.screenshot({path:'/tmp/m/shots/'+name+'.png',fullPage:size==='wide'}); console.log(name, (await p.evaluate(()=>document.documentElement.scrollWidth>innerWidth))?'SIDEWAYS':'' ) } catch(e){console.log('ERR',path,e.message.slice(0,200))} }
await b.close()
